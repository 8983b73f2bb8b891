//! What a scene is drawn as.

use crate::scene::Scene;
use crate::{page, svg};

impl Scene {
    /// The scene as a picture in Scalable Vector Graphics (SVG), of the scene's size and from the
    /// scene's view.
    ///
    /// The picture has a title and a description for screen readers, and follows the reader's
    /// preference for a light or a dark background. The same scene always gives the same text.
    #[must_use]
    pub fn to_svg(&self) -> String {
        svg::draw(self)
    }

    /// The scene as an HTML page that is complete in itself: it needs no network and no other file.
    ///
    /// Dragging with the mouse or a finger rotates the scene, and so do the arrow keys; the wheel,
    /// two fingers, `+` and `-` zoom; a double click, `0` or Home restores the first view. A
    /// fragment such as `#turn=40,20&zoom=1.5` in the address sets azimuth and elevation in degrees
    /// and the zoom. Without scripts the page shows the picture of [`to_svg`](Self::to_svg).
    #[must_use]
    pub fn to_html(&self) -> String {
        page::write(self)
    }
}
