//! Why calibrations fail.

use super::outlier::Outlier;
use super::pair_names::PairNames;
use ga_camera::CameraError;
use ga_camera::rig::RigError;
use ga_image::plane::PlaneError;
use ga_numerics::least_squares::LeastSquaresError;

/// Why a calibration failed, or no chessboard was found for one.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum CalibrationError {
    /// Too few boards were found.
    #[error("a calibration needs {LEAST_VIEWS} boards or more, not {found}")]
    TooFewViews {
        /// How many there are.
        found: usize,
    },
    /// Two cameras have different numbers of views.
    #[error("{left} boards in the left views, {right} in the right ones")]
    Counts {
        /// Views of the left, or the first, camera.
        left: usize,
        /// Views of the right, or another, camera.
        right: usize,
    },
    /// There are views, sizes or options of different numbers of cameras.
    #[error("views of {views} cameras, and sizes or options of {other}")]
    CameraCounts {
        /// Cameras with views.
        views: usize,
        /// Cameras with sizes or options.
        other: usize,
    },
    /// A view shows too little of a board.
    #[error("view {view} shows {found} points of the board, and {LEAST_POINTS} are needed")]
    TooFewPoints {
        /// The view, from 0.
        view: usize,
        /// How many points it shows; in both views, where there are two.
        found: usize,
    },
    /// A view shows a point of a board twice.
    #[error("point {point} of the board is there twice")]
    RepeatedPoint {
        /// The point, from 0.
        point: usize,
    },
    /// A view shows a point that the board does not have.
    #[error("view {view} shows point {point} of a board of {count} points, which count from 0")]
    NoSuchPoint {
        /// The view, from 0.
        view: usize,
        /// The point, from 0.
        point: usize,
        /// How many points the board has.
        count: usize,
    },
    /// A point in a picture or on the board is not finite.
    #[error("point {point} of view {view} is not finite")]
    NotFinite {
        /// The view, from 0.
        view: usize,
        /// The point of the board, from 0.
        point: usize,
    },
    /// The corners of a view lie on one line, or do not belong to a board in front of the camera.
    #[error("the corners of view {view} are not those of a board in front of the camera")]
    View {
        /// The view, from 0.
        view: usize,
    },
    /// The motions between the cameras that fit most boards move a board to where a camera that
    /// shows it cannot see it.
    #[error("the board of view {pair} lies where one of the cameras that show it cannot see it")]
    Unseen {
        /// The pair, or the frame of a rig, from 0.
        pair: usize,
    },
    /// Something is wrong with one of several cameras.
    #[error("camera {camera}: {error}")]
    OfCamera {
        /// The camera, from 0.
        camera: usize,
        /// What is wrong; a view is counted among all frames.
        error: Box<CalibrationError>,
    },
    /// Some cameras see no board together with the others, so that nothing says where they are.
    #[error("no board joins the cameras {} with the first one", counted(.cameras))]
    Disconnected {
        /// The cameras, from 0.
        cameras: Vec<usize>,
    },
    /// The same with the names of the cameras.
    #[error("no board joins {} with the first camera", .cameras.join(", "))]
    Unjoined {
        /// The cameras.
        cameras: Vec<String>,
    },
    /// At least half of the pairs do not agree with the others.
    #[error(
        "at least half of the {pairs} pairs do not agree with the others; pair {}: {outlier}",
        outlier.pair
    )]
    Disagreement {
        /// How many pairs there are.
        pairs: usize,
        /// The outlier after which no more than half of the pairs would be left.
        outlier: Outlier,
    },
    /// A point lies where the lens that is given sees nothing.
    #[error("point {point} of view {view}: {error}")]
    Pixel {
        /// The view, from 0.
        view: usize,
        /// The point of the board, from 0.
        point: usize,
        /// What is wrong with it.
        error: CameraError,
    },
    /// The size of the pictures does not form a camera.
    #[error("no camera to begin with: {0}")]
    Camera(#[from] CameraError),
    /// The bundle adjustment failed.
    #[error("the calibration failed: {0}")]
    LeastSquares(#[from] LeastSquaresError),
    /// The distance between the cameras cannot be told from 0, as where both cameras have the same
    /// pictures.
    #[error("the baseline of {metres:.3e} m cannot be told from 0: are the views of two cameras?")]
    Baseline {
        /// The distance that was found, in metres.
        metres: f64,
    },
    /// The views do not determine a parameter: boards that are all parallel do not determine the
    /// focal length.
    #[error("the views do not determine {parameter}: show the board at more angles")]
    Undetermined {
        /// The name of the parameter.
        parameter: &'static str,
    },
    /// A text does not name coefficients of a lens.
    #[error(
        "{0:?} does not name the terms of a lens: give none, fisheye, or different names of \
         k1, k2, p1, p2, k3, k4, k5, k6, s1, s2, s3, s4, separated by commas"
    )]
    LensTerms(String),
    /// The board is too small to be told from other textures, or larger than any.
    #[error("a board of {columns} × {rows} points: each count must be from 3 to 100")]
    BoardSize {
        /// Corners in a row.
        columns: usize,
        /// Rows.
        rows: usize,
    },
    /// A text is not a size such as `9x6`.
    #[error("{0:?} is not a size of a board such as 9x6")]
    BoardText(String),
    /// The picture shows no complete board of the size.
    #[error(
        "board not found: no complete grid of {} × {} inner corners; \
         the largest grid has {corners} corners within {} columns and {} rows",
        size[0], size[1], extent[0], extent[1]
    )]
    NotFound {
        /// Columns and rows of inner corners that were wanted.
        size: [usize; 2],
        /// How many corners the largest grid has, 0 where there is none.
        corners: usize,
        /// Columns and rows of the smallest rectangle that contains this grid.
        extent: [usize; 2],
    },
    /// The picture shows too few points of a board with tags.
    #[error(
        "board not found: {found} of its {count} points are seen, and {LEAST_FOUND} are needed, \
         with four around a square or a tag among them"
    )]
    TagsNotFound {
        /// How many points are seen.
        found: usize,
        /// How many the board has.
        count: usize,
    },
    /// The picture shows no grid of circles of the size.
    #[error(
        "board not found: no grid of {} × {} circles alone; of {discs} discs {largest} lie in the \
         largest grid",
        size[0], size[1]
    )]
    CirclesNotFound {
        /// Circles in a row, and rows, that were wanted.
        size: [usize; 2],
        /// How many discs there are.
        discs: usize,
        /// How many of them lie in the largest grid.
        largest: usize,
    },
    /// A length on a board is not positive and finite.
    #[error(
        "a board with squares or distances of {metres} m: the length must be positive and finite"
    )]
    Spacing {
        /// The length in metres.
        metres: f64,
    },
    /// The blur of a picture failed.
    #[error(transparent)]
    Blur(#[from] PlaneError),
    /// Pictures have different sizes.
    #[error(
        "the views differ in size: {name} has {} × {} pixels and {first} has {} × {}",
        size[0], size[1], expected[0], expected[1]
    )]
    PictureSizes {
        /// The name of a picture.
        name: String,
        /// Its columns and rows.
        size: [usize; 2],
        /// The name of the first picture.
        first: String,
        /// Its columns and rows.
        expected: [usize; 2],
    },
    /// The board was found in too few pairs of pictures.
    #[error(
        "the board was found in {found} of {pairs} pairs, and {LEAST_VIEWS} are needed{}",
        first.as_ref().map(|first| format!("; first: {first}")).unwrap_or_default()
    )]
    TooFewBoards {
        /// In how many pairs.
        found: usize,
        /// How many there are.
        pairs: usize,
        /// Why it was not found in the first of the others.
        first: Option<String>,
    },
    /// The pictures of one camera have several sizes.
    #[error("the pictures differ in size: {}", sizes(.groups))]
    MixedSizes {
        /// Each size with the names of its pictures.
        groups: Vec<([usize; 2], Vec<String>)>,
    },
    /// The board was found in too few pictures.
    #[error(
        "the board was found in {found} of {pictures} pictures, and {LEAST_VIEWS} are needed{}",
        first.as_ref().map(|first| format!("; first: {first}")).unwrap_or_default()
    )]
    TooFewPictures {
        /// In how many pictures.
        found: usize,
        /// How many there are.
        pictures: usize,
        /// Why it was not found in the first of the others.
        first: Option<String>,
    },
    /// The calibration fails with the lens that is given, and not with another.
    #[error("{error}; the lens seems to be another: {lens} leaves {rms:.3} px")]
    OtherLens {
        /// How it fails.
        error: Box<CalibrationError>,
        /// The other lens.
        lens: String,
        /// What that leaves, in pixels.
        rms: f64,
    },
    /// A picture, or a camera, is to blame.
    #[error("{name}: {error}")]
    Picture {
        /// The name of the picture or the camera.
        name: String,
        /// What is wrong, where pictures with a board count from 0.
        error: Box<CalibrationError>,
    },
    /// A pair of pictures is to blame.
    #[error("{names}: {error}")]
    Pair {
        /// The names of the pictures.
        names: PairNames,
        /// What is wrong, where pairs with a board count from 0.
        error: Box<CalibrationError>,
    },
    /// The edges of the squares cannot be measured with the rig.
    #[error("the edges of the squares cannot be measured: {0}")]
    Edges(Box<RigError>),
}

fn counted(cameras: &[usize]) -> String {
    let cameras: Vec<String> = cameras.iter().map(usize::to_string).collect();
    cameras.join(", ")
}

fn sizes(groups: &[([usize; 2], Vec<String>)]) -> String {
    let groups = groups.iter().map(|([width, height], names)| {
        let names = names.join(", ");
        format!("{width} × {height} pixels have {names}")
    });
    groups.collect::<Vec<_>>().join("; ")
}

/// The least number of boards from which a camera is calibrated.
pub const LEAST_VIEWS: usize = 3;

/// The least number of points of a board with tags that a picture must show.
pub(crate) const LEAST_FOUND: usize = 6;

/// The least number of points of a board from which it is placed.
pub const LEAST_POINTS: usize = 4;

impl CalibrationError {
    /// Whether a picture shows no board.
    #[must_use]
    pub fn is_not_found(&self) -> bool {
        matches!(
            self,
            Self::NotFound { .. } | Self::CirclesNotFound { .. } | Self::TagsNotFound { .. }
        )
    }

    /// The error of chosen views with the index that a view has among all.
    pub(super) fn in_frames(mut self, frames: &[usize]) -> Self {
        if let Some(view) = self.own_view() {
            *view = frames[*view];
        }
        self
    }

    /// The view that is to blame, counted among those of one camera.
    fn own_view(&mut self) -> Option<&mut usize> {
        match self {
            Self::TooFewPoints { view, .. }
            | Self::NoSuchPoint { view, .. }
            | Self::NotFinite { view, .. }
            | Self::Pixel { view, .. }
            | Self::View { view } => Some(view),
            Self::OfCamera { error, .. } => error.own_view(),
            _ => None,
        }
    }

    /// The error of one of several cameras.
    pub(super) fn of_camera(self, camera: usize) -> Self {
        Self::OfCamera {
            camera,
            error: Box::new(self),
        }
    }

    /// The view, or the pair, that is to blame, from 0.
    #[must_use]
    pub fn view(&self) -> Option<usize> {
        match *self {
            Self::TooFewPoints { view, .. }
            | Self::NoSuchPoint { view, .. }
            | Self::NotFinite { view, .. }
            | Self::Pixel { view, .. }
            | Self::View { view }
            | Self::Unseen { pair: view } => Some(view),
            Self::Disagreement { outlier, .. } => Some(outlier.pair),
            Self::OtherLens { ref error, .. } | Self::OfCamera { ref error, .. } => error.view(),
            _ => None,
        }
    }
}
