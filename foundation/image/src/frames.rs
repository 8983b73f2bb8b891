//! Films whose pictures may fail to be made.

/// Calls an encoder of a film with pictures that are made one after another, until one fails: an
/// encoder asks for pictures, not for errors. What it makes of the pictures before the error is
/// dropped.
///
/// # Errors
///
/// That of the first picture that cannot be made.
///
/// ```
/// use ga_image::plane::Plane;
/// use ga_image::{frames, y4m};
///
/// let frames = |fault: u8| {
///     (0..3u8).map(move |frame| match frame == fault {
///         true => Err(format!("frame {frame} has no light")),
///         false => Ok(Plane::filled(4, 2, [80 * frame; 3])),
///     })
/// };
/// let encode = |fault| frames::encode(frames(fault), |f| y4m::encode(f, y4m::Film::default()));
/// assert!(encode(9)?.is_ok());
/// assert_eq!(encode(1).unwrap_err(), "frame 1 has no light");
/// # Ok::<(), String>(())
/// ```
pub fn encode<P, T, E>(
    pictures: impl ExactSizeIterator<Item = Result<P, E>>,
    encoder: impl FnOnce(&mut dyn ExactSizeIterator<Item = P>) -> T,
) -> Result<T, E> {
    let mut made = Made {
        pictures,
        failure: None,
    };
    let encoded = encoder(&mut made);
    match made.failure {
        Some(error) => Err(error),
        None => Ok(encoded),
    }
}

/// The pictures before the first error.
struct Made<I, E> {
    pictures: I,
    failure: Option<E>,
}

impl<P, E, I: ExactSizeIterator<Item = Result<P, E>>> Iterator for Made<I, E> {
    type Item = P;

    fn next(&mut self) -> Option<P> {
        if self.failure.is_some() {
            return None;
        }
        let made = self.pictures.next()?;
        made.map_err(|error| self.failure = Some(error)).ok()
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        self.pictures.size_hint()
    }
}

impl<P, E, I: ExactSizeIterator<Item = Result<P, E>>> ExactSizeIterator for Made<I, E> {}
