#pragma once
#include <optional>

#include "render/look.hpp"
#include "render/picture/overlay.hpp"
#include "solver/run_info.hpp"

namespace seiche::render {

/// What a picture of one run is headed: scene, kernel, spacing.
std::string caption_of(const RunInfo& run);

/// The words around the tank: caption, clock, ruler, and the key to the marks.
class Annotations {
 public:
  /// `ruler`: its length [m].
  Annotations(const RunInfo& run, const Look& look, std::string caption, double ruler)
      : run_(run), look_(look), caption_(std::move(caption)), ruler_(ruler) {}

  /// Fills in what they take up. The ruler's edge of the tank is seen `foreshortened` times its length.
  void reserve(Needs& needs, double foreshortened) const;

  /// @param arrow_font of the arrow in the key, as of those in the picture [pixels]
  void place(vtkRenderer* renderer, const Layout& layout, double foreshortened, double arrow_font, Rgb foreground);
  void set_time(double seconds);

 private:
  bool keyed_wall() const;
  bool keyed_arrow() const;
  double marks_width() const;  // in the key, in font heights
  double arrow_width() const;
  void place_ruler(const Layout& layout, double foreshortened, Rgb foreground);
  void place_key(const Layout& layout, double arrow_font, Rgb foreground);

  RunInfo run_;
  Look look_;
  std::string caption_;
  double ruler_;
  std::optional<Overlay> overlay_;
  vtkTextActor* clock_ = nullptr;  // owned by the overlay
};

}  // namespace seiche::render
