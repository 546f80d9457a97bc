// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace mesecina {

/// How fine pictures are where OpenGL draws without a graphics card: coarser ones while the view moves, so that it can
/// be turned, and fine ones when it rests. It learns from how long pictures took.
class Frame_pace {
 public:
  /// Frame_3::coarseness of the next picture while the view moves: a power of two up to 8.
  int coarseness() const { return coarseness_; }
  /// A picture with one sample for each square of `coarseness` x `coarseness` pixels took so long.
  void took(double seconds, int coarseness);
  /// Whether a picture at rest with so many samples per pixel takes no longer than one waits for it; true before
  /// anything is known.
  bool affords(int samples_per_pixel) const;

 private:
  int coarseness_ = 1;
  double full_seconds_ = 0;  ///< of a picture with one sample per pixel, as the last one lets expect
};

}  // namespace mesecina
