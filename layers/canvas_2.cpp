// SPDX-License-Identifier: GPL-3.0-or-later
#include "layers/canvas_2.h"

#include <QAction>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QNativeGestureEvent>
#include <QPinchGesture>
#include <QWheelEvent>
#include <cmath>

#include "layers/canvas_surface.h"
#include "layers/software_pictures.h"
#include "layers/view_navigation.h"

namespace mesecina {

namespace {

constexpr double zoom_per_wheel_unit = 1.0015;
/// Of horizontal scrolling where the device tells no pixels.
constexpr double pixels_per_wheel_unit = 0.5;

Canvas_2::Backend wanted_backend(Canvas_2::Backend backend) {
  if (backend != Canvas_2::Backend::automatic) return backend;
  const QByteArray wish = qgetenv("MESECINA_CANVAS");
  if (wish == "painter") return Canvas_2::Backend::painter;
  if (wish == "opengl") return Canvas_2::Backend::opengl;
  return backend;
}

}  // namespace

struct Canvas_2::State {
  Canvas_2& canvas;
  Canvas_content content;
  std::unique_ptr<Canvas_surface> surface;
  Canvas_tool* tool = nullptr;
  View_history history;
  std::optional<Box> box_to_fit;  ///< again when the canvas gets another size, until the user moves the view

  Qt::MouseButton pan_button = Qt::NoButton;  ///< none: no pan is going on
  QPointF pan_position;
  bool space_is_held = false;
  bool space_was_used = false;
  bool shows_pan_cursor = false;
  std::optional<QCursor> own_cursor;  ///< what the canvas had before the cursor of a pan

  explicit State(Canvas_2& owner) : canvas(owner) {}

  void choose_surface(Backend backend) {
    if (backend == Backend::painter) {
      use_painter({});
      return;
    }
    const Opengl_probe probe = probe_opengl();
    if (probe.reason.isEmpty() && probe.is_software && backend == Backend::automatic) {
      show_surface(std::make_unique<Painter_surface_2>(content, tr("QPainter, OpenGL in software: %1").arg(probe.name),
                                                       std::make_unique<Software_pictures>(), &canvas));
      return;
    }
    if (probe.reason.isEmpty()) {
      use_opengl();
      return;
    }
    use_painter(probe.reason);
    // Nobody can listen before the constructor is done.
    QMetaObject::invokeMethod(
        &canvas, [this, reason = probe.reason] { Q_EMIT canvas.backend_failed(reason); }, Qt::QueuedConnection);
  }
  void use_opengl() {
    const auto fail = [this](const QString& reason) {
      // Perhaps while painting, when the surface must not be replaced.
      QMetaObject::invokeMethod(
          &canvas, [this, reason] { fall_back(reason); }, Qt::QueuedConnection);
    };
    show_surface(std::make_unique<Gl_surface_2>(content, fail, &canvas));
  }
  void fall_back(const QString& reason) {
    use_painter(reason);
    Q_EMIT canvas.backend_failed(reason);
  }
  void use_painter(const QString& reason) {
    const QString description =
        reason.isEmpty() ? QStringLiteral("QPainter") : tr("QPainter (no OpenGL: %1)").arg(reason);
    show_surface(std::make_unique<Painter_surface_2>(content, description, nullptr, &canvas));
  }
  void show_surface(std::unique_ptr<Canvas_surface> made) {
    surface = std::move(made);
    QWidget& widget = surface->widget();
    widget.setAttribute(Qt::WA_TransparentForMouseEvents);
    widget.setFocusPolicy(Qt::NoFocus);
    widget.setGeometry(canvas.rect());
    widget.show();
  }

  void show_view(const View_2& view) {
    if (view == content.view) return;
    content.view = view;
    surface->widget().update();
    Q_EMIT canvas.view_changed(view);
  }
  void step_to(const View_2& view) {
    box_to_fit.reset();
    history.step(content.view, view, std::chrono::steady_clock::now());
    show_view(view);
  }
  void zoom_at(double factor, const QPointF& pixel) {
    step_to(zoomed(content.view, factor, {pixel.x(), pixel.y()}, canvas.width(), canvas.height()));
  }
  View_2 fitting_view(const Box& box) const {
    const View_2 view = fit_view(box, std::max(canvas.width(), 1), std::max(canvas.height(), 1));
    return limited(view).value_or(content.view);
  }

  void update_cursor() {
    const bool wanted = pan_button != Qt::NoButton || space_is_held;
    if (wanted && !shows_pan_cursor) {
      own_cursor.reset();
      if (canvas.testAttribute(Qt::WA_SetCursor)) own_cursor = canvas.cursor();
    }
    if (wanted) {
      canvas.setCursor(pan_button != Qt::NoButton ? Qt::ClosedHandCursor : Qt::OpenHandCursor);
    } else if (shows_pan_cursor) {
      if (own_cursor)
        canvas.setCursor(*own_cursor);
      else
        canvas.unsetCursor();
    }
    shows_pan_cursor = wanted;
  }

  Canvas_event to_canvas_event(const QMouseEvent& event) const {
    const QPointF pixel = event.position();
    return {pixel, content.view.to_plane({pixel.x(), pixel.y()}, canvas.width(), canvas.height()), event.button(),
            event.buttons(), event.modifiers()};
  }

  bool press(const QMouseEvent& event, bool is_double) {
    if (pan_button != Qt::NoButton) return true;
    const bool starts_pan = event.button() == Qt::MiddleButton || (event.button() == Qt::LeftButton && space_is_held);
    if (!starts_pan) {
      if (!tool) return false;
      return is_double ? tool->double_click(to_canvas_event(event)) : tool->press(to_canvas_event(event));
    }
    pan_button = event.button();
    pan_position = event.position();
    space_was_used = space_is_held;
    history.begin_gesture(content.view);
    update_cursor();
    return true;
  }
  bool move(const QMouseEvent& event) {
    if (pan_button == Qt::NoButton) return tool && tool->move(to_canvas_event(event));
    const QPointF moved = event.position() - pan_position;
    pan_position = event.position();
    step_to(panned(content.view, moved.x(), moved.y()));
    return true;
  }
  bool release(const QMouseEvent& event) {
    if (pan_button == Qt::NoButton || event.button() != pan_button)
      return tool && tool->release(to_canvas_event(event));
    end_pan();
    return true;
  }
  void end_pan() {
    pan_button = Qt::NoButton;
    history.end_gesture();
    update_cursor();
  }

  bool wheel(const QWheelEvent& event) {
    if (event.modifiers() & Qt::AltModifier) return false;
    const QPoint turned = event.angleDelta();
    // A finger on a touchpad never moves quite straight.
    if (std::abs(turned.x()) > 2 * std::abs(turned.y())) {
      const double pixels = event.pixelDelta().isNull() ? turned.x() * pixels_per_wheel_unit : event.pixelDelta().x();
      step_to(panned(content.view, pixels, 0));
    } else if (turned.y() != 0) {
      zoom_at(std::pow(zoom_per_wheel_unit, turned.y()), event.position());
    }
    return true;
  }
  bool native_gesture(const QNativeGestureEvent& event) {
    if (event.gestureType() == Qt::BeginNativeGesture) {
      history.begin_gesture(content.view);
    } else if (event.gestureType() == Qt::EndNativeGesture) {
      history.end_gesture();
    } else if (event.gestureType() == Qt::ZoomNativeGesture) {
      zoom_at(1 + event.value(), event.position());
    } else {
      return false;
    }
    return true;
  }
  bool gesture(const QGestureEvent& event) {
    const auto* pinch = static_cast<QPinchGesture*>(event.gesture(Qt::PinchGesture));
    if (!pinch) return false;
    if (pinch->state() == Qt::GestureStarted) history.begin_gesture(content.view);
    const QPointF moved = pinch->centerPoint() - pinch->lastCenterPoint();
    if (pinch->changeFlags() & QPinchGesture::CenterPointChanged) step_to(panned(content.view, moved.x(), moved.y()));
    if (pinch->changeFlags() & QPinchGesture::ScaleFactorChanged)
      zoom_at(pinch->scaleFactor(), canvas.mapFromGlobal(pinch->centerPoint()));
    if (pinch->state() == Qt::GestureFinished || pinch->state() == Qt::GestureCanceled) history.end_gesture();
    return true;
  }

  bool key(const QKeyEvent& event, bool is_pressed) {
    if (event.key() != Qt::Key_Space || (event.modifiers() != Qt::NoModifier && is_pressed)) return false;
    if (event.isAutoRepeat()) return true;
    if (is_pressed == space_is_held) return is_pressed;
    space_is_held = is_pressed;
    if (is_pressed)
      space_was_used = false;
    else if (!space_was_used)
      trigger_space_shortcut();
    update_cursor();
    return true;
  }
  /// Space that panned nothing does what it does elsewhere in the window.
  void trigger_space_shortcut() const {
    for (QAction* action : canvas.window()->findChildren<QAction*>()) {
      if (!action->isEnabled() || !action->shortcuts().contains(QKeySequence(Qt::Key_Space))) continue;
      action->trigger();
      return;
    }
  }
  void lose_focus() {
    space_is_held = false;
    update_cursor();
  }
  void resize() {
    surface->widget().setGeometry(canvas.rect());
    if (box_to_fit) show_view(fitting_view(*box_to_fit));
  }
  void leave() const {
    if (tool) tool->leave();
  }
};

Canvas_2::Canvas_2(Backend backend, QWidget* parent) : QWidget(parent), state_(std::make_unique<State>(*this)) {
  state_->choose_surface(wanted_backend(backend));
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setAccessibleName(tr("Canvas"));
  setAccessibleDescription(
      tr("The picture of the layers. Turn the wheel to zoom, drag with the middle button to pan."));
  setMinimumSize(80, 60);
  grabGesture(Qt::PinchGesture);
}

// While the surface goes, this may still receive events, which need the rest of the state.
Canvas_2::~Canvas_2() { state_->surface.reset(); }

void Canvas_2::set_scene(Scene scene) {
  state_->content.scene = std::move(scene);
  state_->surface->scene_changed();
}

const Scene& Canvas_2::scene() const { return state_->content.scene; }

void Canvas_2::set_overlay(std::vector<Scene_layer> overlay) {
  if (overlay.empty() && state_->content.overlay.empty()) return;
  state_->content.overlay = std::move(overlay);
  state_->surface->widget().update();
}

void Canvas_2::set_rubber_band(std::optional<QRectF> rectangle) {
  state_->content.rubber_band = rectangle;
  state_->surface->widget().update();
}

void Canvas_2::set_hint(const QString& text) {
  state_->content.hint = text;
  state_->surface->widget().update();
}

const View_2& Canvas_2::view() const { return state_->content.view; }

void Canvas_2::set_view(const View_2& view) {
  if (const auto allowed = limited(view)) state_->step_to(*allowed);
}

void Canvas_2::fit(const Box& box) {
  const View_2 view = state_->fitting_view(box);
  if (isVisible()) state_->history.jump(state_->content.view, view);
  state_->box_to_fit = box;
  state_->show_view(view);
}

void Canvas_2::previous_view() {
  const auto view = state_->history.take(state_->content.view);
  if (!view) return;
  state_->box_to_fit.reset();
  state_->show_view(*view);
}

void Canvas_2::zoom(double factor) {
  if (factor > 0) state_->zoom_at(factor, QPointF(width() / 2.0, height() / 2.0));
}

void Canvas_2::set_tool(Canvas_tool* tool) { state_->tool = tool; }

QString Canvas_2::backend_name() const { return state_->surface->description(); }

bool Canvas_2::uses_opengl() const { return dynamic_cast<const Gl_surface_2*>(state_->surface.get()) != nullptr; }

std::size_t Canvas_2::uploaded_bytes() const { return state_->surface->uploaded_bytes(); }

QImage Canvas_2::grab_picture() { return state_->surface->grab_picture(); }

bool Canvas_2::event(QEvent* event) {
  State& state = *state_;
  bool used = false;
  switch (event->type()) {
    case QEvent::MouseButtonPress:
      used = state.press(static_cast<QMouseEvent&>(*event), false);
      break;
    case QEvent::MouseButtonDblClick:
      used = state.press(static_cast<QMouseEvent&>(*event), true);
      break;
    case QEvent::MouseMove:
      used = state.move(static_cast<QMouseEvent&>(*event));
      break;
    case QEvent::MouseButtonRelease:
      used = state.release(static_cast<QMouseEvent&>(*event));
      break;
    case QEvent::Wheel:
      used = state.wheel(static_cast<QWheelEvent&>(*event));
      break;
    case QEvent::NativeGesture:
      used = state.native_gesture(static_cast<QNativeGestureEvent&>(*event));
      break;
    case QEvent::Gesture:
      used = state.gesture(static_cast<QGestureEvent&>(*event));
      break;
    case QEvent::KeyPress:
      used = state.key(static_cast<QKeyEvent&>(*event), true);
      break;
    case QEvent::KeyRelease:
      used = state.key(static_cast<QKeyEvent&>(*event), false);
      break;
    case QEvent::ShortcutOverride: {
      const auto& key = static_cast<QKeyEvent&>(*event);
      used = key.key() == Qt::Key_Space && key.modifiers() == Qt::NoModifier;
      break;
    }
    case QEvent::Leave:
      state.leave();
      break;
    case QEvent::FocusOut:
      state.lose_focus();
      break;
    case QEvent::Resize:
      state.resize();
      break;
    default:
      break;
  }
  if (used) {
    event->accept();
    return true;
  }
  return QWidget::event(event);
}

}  // namespace mesecina
