//! Pictures whose kind of pixel is known only at run time, as they come from files.

pub(crate) mod convert;
mod warped;
mod white;

use crate::orientation::Orientation;
use crate::plane::{Plane, PlaneView};

macro_rules! kinds {
    ($($(#[$doc:meta])* $kind:ident($pixel:ty), $name:literal;)*) => {
        /// A picture with any kind of pixel that picture files have.
        ///
        /// A reader returns what the file holds, without a change of depth. Code that wants one
        /// kind asks for it: [`to_grey`](Self::to_grey), [`to_rgb`](Self::to_rgb) and
        /// [`to_rgba`](Self::to_rgba) convert from every other.
        ///
        /// ```
        /// use ga_image::grey::Luma;
        /// use ga_image::picture::Picture;
        /// use ga_image::plane::Plane;
        ///
        /// let picture = Picture::from(Plane::filled(2, 1, [255u8, 0, 0]));
        /// assert_eq!(picture.to_rgba::<u16>().get(0, 0), Some([65535, 0, 0, 65535]));
        /// assert_eq!(picture.to_grey::<u8>(Luma::Bt601).get(0, 0), Some(76));
        /// ```
        #[derive(Clone, Debug, PartialEq)]
        pub enum Picture {
            $($(#[$doc])* $kind(Plane<$pixel>),)*
        }

        /// A [`Picture`], borrowed; what the writers of files take. It is made from a plane, a view
        /// of a plane, a picture of the crate [`image`] or a [`Picture`].
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub enum PictureView<'a> {
            $($(#[$doc])* $kind(PlaneView<'a, $pixel>),)*
        }

        impl Picture {
            /// The same picture, borrowed.
            #[must_use]
            pub fn view(&self) -> PictureView<'_> {
                match self {
                    $(Self::$kind(plane) => PictureView::$kind(plane.view()),)*
                }
            }
        }

        impl Picture {
            /// The picture after the change that an orientation stands for; see
            /// [`Plane::oriented`].
            #[must_use]
            pub fn oriented(&self, orientation: Orientation) -> Self {
                match self {
                    $(Self::$kind(plane) => Self::$kind(plane.oriented(orientation)),)*
                }
            }
        }

        impl PictureView<'_> {
            /// Columns.
            #[must_use]
            pub fn width(&self) -> usize {
                match self {
                    $(Self::$kind(plane) => plane.width(),)*
                }
            }

            /// Rows.
            #[must_use]
            pub fn height(&self) -> usize {
                match self {
                    $(Self::$kind(plane) => plane.height(),)*
                }
            }

            /// The kind of pixel, in words.
            #[must_use]
            pub fn kind(&self) -> &'static str {
                match self {
                    $(Self::$kind(_) => $name,)*
                }
            }

            /// A copy of the picture.
            #[must_use]
            pub fn to_picture(&self) -> Picture {
                match self {
                    $(Self::$kind(plane) => Picture::$kind(plane.to_plane()),)*
                }
            }
        }

        $(
            impl From<Plane<$pixel>> for Picture {
                fn from(plane: Plane<$pixel>) -> Self {
                    Self::$kind(plane)
                }
            }

            impl<'a> From<&'a Plane<$pixel>> for PictureView<'a> {
                fn from(plane: &'a Plane<$pixel>) -> Self {
                    Self::$kind(plane.view())
                }
            }

            impl<'a> From<PlaneView<'a, $pixel>> for PictureView<'a> {
                fn from(view: PlaneView<'a, $pixel>) -> Self {
                    Self::$kind(view)
                }
            }
        )*
    };
}

kinds! {
    /// Grey, 8 bits.
    Grey8(u8), "8-bit grey";
    /// Grey and alpha, 8 bits each.
    GreyAlpha8([u8; 2]), "8-bit grey with alpha";
    /// Red, green and blue, 8 bits each.
    Rgb8([u8; 3]), "8-bit RGB";
    /// Red, green, blue and alpha, 8 bits each.
    Rgba8([u8; 4]), "8-bit RGBA";
    /// Grey, 16 bits.
    Grey16(u16), "16-bit grey";
    /// Grey and alpha, 16 bits each.
    GreyAlpha16([u16; 2]), "16-bit grey with alpha";
    /// Red, green and blue, 16 bits each.
    Rgb16([u16; 3]), "16-bit RGB";
    /// Red, green, blue and alpha, 16 bits each.
    Rgba16([u16; 4]), "16-bit RGBA";
    /// Grey, or any other single number, as a float.
    GreyF32(f32), "grey of floats";
    /// Red, green and blue as floats.
    RgbF32([f32; 3]), "RGB of floats";
}

impl Picture {
    /// Columns.
    #[must_use]
    pub fn width(&self) -> usize {
        self.view().width()
    }

    /// Rows.
    #[must_use]
    pub fn height(&self) -> usize {
        self.view().height()
    }
}

impl<'a> From<&'a Picture> for PictureView<'a> {
    fn from(picture: &'a Picture) -> Self {
        picture.view()
    }
}
