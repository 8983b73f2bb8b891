//! The options of the command.

use std::path::PathBuf;

use ga_vision::capture::{KeyArea, PoseOptions};

/// Separate captured points of a face into the pose of the head and its expression.
///
/// POINTS has a row for each frame and three columns for each point. The first line names them
/// NAME_x, NAME_y, NAME_z; columns such as `frame` and `time`, `Time (Seconds)` or `time_seconds`
/// may come first. Without a line of names, points are 0, 1, 2 and so on. Commas, tabs or
/// semicolons are between the fields, and after semicolons numbers may have decimal commas. Lengths
/// are in metres.
///
/// Exports of Motive (OptiTrack) and Nexus (Vicon) as CSV, and TRC of OpenSim and Pose2Sim, are
/// known by what they say, whatever the ending of the file; their unit becomes metres. Columns that
/// are not positions of named markers, as those of rigid bodies, are passed over, which a warning
/// says. `face:brow` may be called `brow`. C3D is not read: export it as TRC or CSV.
///
/// A point that was not seen has fields that are empty or NaN, NA, N/A, #N/A or null. A point that
/// is exactly 0,0,0 in some frames and elsewhere in others was lost there, which a warning says;
/// one that is 0,0,0 in all frames stays there, but several such points were never seen.
/// --keep-zeros takes all as they are. Points that are seen in no frame are left out.
///
/// Calibrated points are three or more that no expression moves, such as temples, forehead and the
/// bridge of the nose. They need not be in all frames: three that are not on one line show the
/// pose. A frame with fewer has neither pose nor expression: its fields are empty in CSV, its
/// numbers are null in JSON, with a `pose_reason`, and glTF has no keys for it, so that programs
/// interpolate between the frames before and after it. A warning counts and names such frames.
///
/// The pose of a frame is the motion of the head since the reference frame, in which all points
/// must be seen, and the expression of a point is its displacement beyond that, in the coordinates
/// of the reference frame.
///
/// With --mesh, a surface follows the points: seen from its centre of gravity, the displacements
/// of the keys are interpolated on the sphere by a smooth spline, exactly at the keys. KEYS.csv
/// says where points are on the mesh, with the columns `point,vertex` (from 0) or `point,x,y,z`;
/// without it, all points of the reference frame are in the coordinates of the mesh.
///
/// The ending of --out decides what is written, and --out may be given several times: .csv the
/// expression of each point in each frame, .glb the surface with morph targets whose weights are
/// animated together with the pose of the head, .obj or .ply the surface in one --frame.
///
/// For instance
///
///   nullcone capture points.csv --calibrated brow,nose,left,right --out expression.csv \
///     --mesh face.obj --keys keys.csv --out face.glb --json
///
/// prints {"frames": …, "frames_without_pose": …, "points": …, "calibrated": […],
/// "reference_frame": …, "expression": {"rms_metres": …, "max_metres": …, "max_point": …,
/// "max_frame": …, "points": [{"name": …, "frames_seen": …, "rms_metres": …, "max_metres": …},
/// …]},
/// "poses": [{"frame": …, "translation_metres": […], "rotation_quaternion": [x, y, z, w],
/// "rotation_axis": […], "rotation_degrees": …, "rms_metres": …, "inliers": …, "outliers": […],
/// "missing": […], "pose_reason": …}, …], "surface": {"vertices": …, "keys": …, "keys_filled": …,
/// "key_fit_rms_metres": …, "sphere_centre_metres": […], "folded_triangles": …,
/// "morph_targets": …, "morph_error_max_metres": …, "metres_per_mesh_unit": …,
/// "area": {"vertices": …, "centre_metres": […], "centre_kept": …,
/// "centre_displacement_metres": [[…], …]}}, "seconds": …}. Places on the surface are in the
/// coordinates of the mesh, scaled to metres. At least one of --out, --pose, --matrix, --json and
/// --report says what is made.
#[derive(Clone, Debug, clap::Args)]
#[command(verbatim_doc_comment)]
pub(crate) struct Arguments {
    /// The points in each frame.
    #[arg(value_name = "POINTS")]
    pub(super) points: PathBuf,
    /// The calibrated points, by name or by number from 0.
    #[arg(long, value_name = "POINT,…", value_delimiter = ',', required = true)]
    pub(super) calibrated: Vec<String>,
    /// Take points that are 0,0,0 as they are, not as lost.
    #[arg(long)]
    pub(super) keep_zeros: bool,
    /// The frame in which the head is at rest, by its name in the column `frame` or else by the
    /// number of its row from 0 [default: the first].
    #[arg(long, value_name = "FRAME")]
    pub(super) reference: Option<String>,
    /// Leave out calibrated points that are farther than this from where the pose takes them, in
    /// metres; by default all count.
    #[arg(long, value_name = "METRES")]
    pub(super) threshold: Option<f64>,
    /// The seed of the random samples that find such points.
    #[arg(long, value_name = "N", default_value_t = PoseOptions::default().seed)]
    pub(super) seed: u64,
    /// The surface that follows the points: .obj, .ply, .glb or .gltf.
    #[arg(long, value_name = "MESH")]
    pub(super) mesh: Option<PathBuf>,
    /// Where points are on the mesh. Others do not move it.
    #[arg(long, value_name = "KEYS.csv", requires = "mesh")]
    pub(super) keys: Option<PathBuf>,
    /// Let the mesh have another size or unit than the head. Without this, its unit is the metre.
    #[arg(long, requires = "keys")]
    pub(super) fit_scale: bool,
    /// Move only what is within a radius of a key along the surface, in the unit of the mesh. The
    /// motion falls smoothly to zero at the edge.
    #[arg(long, value_name = "KEY:RADIUS", requires = "mesh")]
    pub(super) area: Option<KeyArea>,
    /// Keep the centre of gravity of the area, or of the whole surface, where it is at rest.
    #[arg(long, requires = "mesh")]
    pub(super) keep_centre: bool,
    /// Leave out the pose of the head, and write the surface in the coordinates of the mesh.
    #[arg(long, requires = "mesh")]
    pub(super) still: bool,
    /// How far a key may be from where morph targets take it, in metres.
    #[arg(long, value_name = "METRES", default_value_t = 1e-6)]
    pub(super) tolerance: f64,
    /// Frames in a second, where the table has no times.
    #[arg(long, value_name = "N", default_value_t = 30.0)]
    pub(super) fps: f64,
    /// The frame of a surface without animation.
    #[arg(long, value_name = "FRAME", requires = "mesh")]
    pub(super) frame: Option<String>,
    /// What to write: .csv, .obj, .ply, .glb or .gltf. May be given several times.
    #[arg(long, value_name = "FILE")]
    pub(super) out: Vec<PathBuf>,
    /// Write the pose of each frame as CSV.
    #[arg(long, value_name = "FILE.csv")]
    pub(super) pose: Option<PathBuf>,
    /// Write the capture matrix of each frame as CSV: the homogeneous coordinates of the points
    /// with the pose taken out.
    #[arg(long, value_name = "FILE.csv")]
    pub(super) matrix: Option<PathBuf>,
}
