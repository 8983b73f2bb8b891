//! What may be wrong about views.

/// What may be wrong about views.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RegistrationOptions {
    /// How well the rotations of the cameras are known: a standard deviation in radians.
    pub rotation: f64,
    /// How well the places of the cameras are known: a standard deviation in metres; 0 where they
    /// are exact. Joints hardly show places: of two to four cameras that are displaced by 1 cm and
    /// see a walking person with 2 px noise, 1 cm leaves 8 mm, and displaces cameras that are right
    /// by 3 mm. Rotations beside each other then are right to 0.06° instead of 0.11°.
    pub position: f64,
    /// By how many frames views may be late or early at most; 0 where all begin together.
    pub most_frames: usize,
}

impl Default for RegistrationOptions {
    /// 0.3 degrees, exact places, and 30 frames.
    fn default() -> Self {
        Self {
            rotation: 0.3_f64.to_radians(),
            position: 0.0,
            most_frames: 30,
        }
    }
}
