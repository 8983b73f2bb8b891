//! What of a motion a format does not hold.

use ga_mesh::gltf::Document;

/// Something of a motion or of its file that is not in the file that was written.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Loss {
    /// What a document shows beside its motion.
    #[error(
        "not in the file: {}",
        listed(&[(*.meshes, "mesh", "meshes"), (*.skins, "skin", "skins")])
    )]
    Meshes {
        /// How many meshes there are.
        meshes: usize,
        /// How many skins.
        skins: usize,
    },
    /// The other animations of a document.
    #[error(
        "not in the file: {}",
        listed(&[(*.animations, "other animation", "other animations")])
    )]
    Animations {
        /// How many.
        animations: usize,
    },
    /// Scalar tracks, such as the weights of morph targets.
    #[error(
        "not in the file: {}: {}",
        listed(&[(.tracks.len(), "scalar track", "scalar tracks")]),
        .tracks.join("; ")
    )]
    Tracks {
        /// Their names.
        tracks: Vec<String>,
    },
    /// Joints are scaled.
    #[error(
        "not in the file: the factors of {}, as of {joint:?} in frame {frame}; joints are where \
         these put them",
        listed(&[(*.joints, "scaled joint", "scaled joints")])
    )]
    Scale {
        /// How many joints.
        joints: usize,
        /// The first of them.
        joint: String,
        /// The first frame in which it is scaled.
        frame: usize,
    },
    /// Axes of joints at rest.
    #[error(
        "not in the file: the axes at rest of {}, as of {joint:?}; rotations are 0 at rest",
        listed(&[(*.joints, "joint", "joints")])
    )]
    JointAxes {
        /// How many joints.
        joints: usize,
        /// The first of them.
        joint: String,
    },
    /// Ends of bones.
    #[error("not in the file: {}", listed(&[(*.joints, "End Site", "End Sites")]))]
    EndSites {
        /// How many joints have one.
        joints: usize,
    },
    /// A joint has another name.
    #[error("joint {joint:?} is called {written:?} in the file")]
    Name {
        /// Its name.
        joint: String,
        /// Its name in the file.
        written: String,
    },
    /// Places are rounded to single precision.
    #[error(
        "places are rounded by up to {rounding:.1e} m in single precision, since {joint:?} is \
         {distance:.0} m from the joint above it or the origin"
    )]
    Precision {
        /// The joint that is farthest away.
        joint: String,
        /// How far, in metres.
        distance: f64,
        /// By how much its place is rounded, in metres.
        rounding: f64,
    },
}

impl Loss {
    /// What a document has beside its joints that a file of another format has not. `replaced` of
    /// its animations are not missed there.
    pub(super) fn of_document(document: &Document, replaced: usize) -> Vec<Self> {
        let (meshes, skins) = (document.meshes.len(), document.skins.len());
        let animations = document.animations.len().saturating_sub(replaced);
        let of_meshes = (meshes + skins > 0).then_some(Self::Meshes { meshes, skins });
        let of_animations = (animations > 0).then_some(Self::Animations { animations });
        of_meshes.into_iter().chain(of_animations).collect()
    }

    /// What it is, as one word for programs.
    #[must_use]
    pub fn kind(&self) -> &'static str {
        match self {
            Self::Meshes { .. } => "meshes_left_out",
            Self::Animations { .. } => "animations_left_out",
            Self::Tracks { .. } => "tracks_left_out",
            Self::Scale { .. } => "scale_left_out",
            Self::JointAxes { .. } => "joint_axes_left_out",
            Self::EndSites { .. } => "end_sites_left_out",
            Self::Name { .. } => "joint_renamed",
            Self::Precision { .. } => "precision",
        }
    }

    /// The joint that it is about, where it is about one.
    #[must_use]
    pub fn joint(&self) -> Option<&str> {
        match self {
            Self::Scale { joint, .. }
            | Self::JointAxes { joint, .. }
            | Self::Name { joint, .. }
            | Self::Precision { joint, .. } => Some(joint),
            _ => None,
        }
    }

    /// The frame that it is about, from 0.
    #[must_use]
    pub fn frame(&self) -> Option<usize> {
        match self {
            Self::Scale { frame, .. } => Some(*frame),
            _ => None,
        }
    }
}

/// Counts with their nouns, but for those of 0, as in `1 mesh and 2 skins`.
fn listed(counts: &[(usize, &str, &str)]) -> String {
    let there = counts.iter().filter(|(count, ..)| *count > 0);
    let words = there.map(|(count, one, several)| match count {
        1 => format!("1 {one}"),
        count => format!("{count} {several}"),
    });
    words.collect::<Vec<_>>().join(" and ")
}
