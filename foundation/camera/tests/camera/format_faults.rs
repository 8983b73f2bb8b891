//! What is wrong with a file of cameras, and where.

use std::path::Path;

use ga_camera::format::{self, CameraFile, CameraFileError};
use tempfile::tempdir;

fn decode(text: &str) -> Result<CameraFile, CameraFileError> {
    format::decode(text.as_bytes(), Path::new("folder"))
}

fn message(text: &str) -> String {
    decode(text).unwrap_err().to_string()
}

#[test]
fn faults_name_key_and_line() {
    let kalibr = "cam0:\n  camera_model: pinhole\n  intrinsics: [525.25, 526.5, 319.5, 239.5]\n  \
                  distortion_model: radtan\n  distortion_coeffs: [-0.37, 0.24, 0.001, -0.002]\n  \
                  resolution: [640, 480]\n";
    let kitti = "P0: 721.5 0 609.5 0 0 721.5 172.8 0 0 0 1 0\n";
    let toml = "[cam_0]\nsize = [640, 480]\nmatrix = [[500.0, 0, 320], [0, 500, 240], [0, 0, 1]]\n\
                distortions = [0.1, 0, 0, 0, 0]\nrotation = [0, 0, 0]\ntranslation = [0, 0, 1]\n";
    let xml = "<?xml version=\"1.0\"?>\n<opencv_storage>\n<K type_id=\"opencv-matrix\">\n<rows>3</rows>\
               <cols>3</cols><dt>d</dt>\n<data>\n5. 0. 3. 0. 5. 2. 0. 0. 1.</data></K>\n\
               </opencv_storage>\n";
    let ros = "width: 640\nheight: 480\ndistortion_model: plumb_bob\nd: [0.1, 0, 0, 0, 0]\n\
               k: [5, 0, 3, 0, 5, 2, 0, 0, 1]\n";
    let colmap = "# Cameras\n1 PINHOLE 640 480 500 500 320 240\n";
    for text in [kalibr, kitti, toml, xml, ros, colmap] {
        decode(text).unwrap();
    }
    for (text, from, to, expected) in [
        (
            kalibr,
            "pinhole",
            "omni",
            "line 2: `cam0.camera_model` is \"omni\", which is not read",
        ),
        (
            kalibr,
            "radtan",
            "fov",
            "line 4: `cam0.distortion_model` is \"fov\"",
        ),
        (
            kalibr,
            "526.5, ",
            "",
            "line 3: `cam0.intrinsics` has 3 × 1 values, not four",
        ),
        (
            kalibr,
            "  intrinsics: [525.25, 526.5, 319.5, 239.5]\n",
            "",
            "line 1: there is no `cam0.intrinsics`",
        ),
        (
            kalibr,
            "0.24",
            "x",
            "line 5: `cam0.distortion_coeffs` is not a number",
        ),
        (
            kitti,
            "609.5",
            "six",
            "line 1: `P0` is not a list of numbers",
        ),
        (
            kitti,
            " 1 0\n",
            " 1\n",
            "line 1: `P0` has 1 × 11 values, not 3 × 4",
        ),
        (kitti, "721.5", "-721.5", "line 1: `P0`: focal lengths"),
        (toml, "320]", "320, 7]", "line 3: `cam_0.matrix`"),
        (toml, "= [0, 0, 1]", "=", "line 6: not TOML"),
        (
            toml,
            "rotation = [0, 0, 0]\n",
            "",
            "line 1: there is no `cam_0.rotation`",
        ),
        (toml, "matrix", "matrox", "there is no `matrix`"),
        (
            xml,
            "0. 0. 1.",
            "0. 1.",
            "line 3: `K` has 8 values, not 3 × 3",
        ),
        (xml, "</K>", "", "line 7: not XML"),
        (xml, "5. 0. 3.", "5. 0. three", "`K` is not a number"),
        (
            ros,
            "plumb_bob",
            "thin_prism",
            "line 3: `distortion_model` is \"thin_prism\"",
        ),
        (ros, "k: [5", "k: [0", "line 5: `k`: focal lengths"),
        (
            ros,
            "width: 640\n",
            "width: 640\nbinning_x: 2\n",
            "line 2: the picture has fewer pixels",
        ),
        (
            colmap,
            "PINHOLE",
            "FOV",
            "line 2: `MODEL` is \"FOV\", which is not read",
        ),
        (colmap, " 240\n", "\n", "line 2: there is no `PARAMS`"),
        (
            colmap,
            "640",
            "0",
            "line 2: `WIDTH` is 0, not a number of pixels",
        ),
    ] {
        let changed = text.replacen(from, to, 1);
        assert_ne!(changed, text, "{from}");
        let found = message(&changed);
        assert!(found.contains(expected), "{found} does not say {expected}");
    }
    // Messages that are printed again say the same; others do not.
    decode(&format!("{ros}---\n{ros}---\n")).unwrap();
    let other = ros.replace("k: [5", "k: [6");
    let found = message(&format!("{ros}---\n{other}"));
    assert!(
        found.starts_with("line 7: a second document begins here"),
        "{found}"
    );
    let found = message("<html></html>");
    assert!(found.contains("there is no `camera_matrix`"), "{found}");
}

const CHAIN: &str = "cam0:
  camera_model: pinhole
  intrinsics: [500, 500, 320, 240]
  distortion_model: none
  distortion_coeffs: []
cam1:
  T_cn_cnm1: [[1, 0, 0, -0.1], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]
  camera_model: pinhole
  intrinsics: [500, 500, 320, 240]
  distortion_model: none
  distortion_coeffs: []
";

/// `T_cn_cnm1` leads from the camera of the number before, which must be in the file.
#[test]
fn chains_of_kalibr_have_no_gaps() {
    decode(CHAIN).unwrap();
    let without_first = CHAIN.replace("cam1:", "cam2:").replace("cam0:", "cam1:");
    decode(&without_first).unwrap();
    let gap = CHAIN.replace("cam1:", "cam2:");
    assert_eq!(
        message(&gap),
        "line 7: `cam2.T_cn_cnm1` leads from the frame of `cam1`, and there is no such camera"
    );
    // By columns, the translation is in the last row.
    let turned = CHAIN
        .replace("0, -0.1]", "0, 0]")
        .replace("0, 0, 1]]", "0.1, 0, 1]]");
    assert!(message(&turned).starts_with("line 7: `cam1.T_cn_cnm1` is not a rotation and a"));
    let mirrored = CHAIN.replace("[[1, 0", "[[-1, 0");
    assert!(message(&mirrored).starts_with("line 7: `cam1.T_cn_cnm1` is not a rotation"));
}

#[test]
fn sizes_of_middlebury_are_whole_and_two() {
    let text = "cam0=[500 0 320; 0 500 240; 0 0 1]\ncam1=[500 0 320; 0 500 240; 0 0 1]\n\
                baseline=100\nwidth=640\nheight=480\nndisp=64\n";
    decode(text).unwrap();
    for (from, to, expected) in [
        ("height=480\n", "", "line 4: there is no `height`"),
        ("width=640\n", "", "line 4: there is no `width`"),
        ("640", "0", "line 4: `width` is 0, not a number of pixels"),
        (
            "480",
            "480.5",
            "line 5: `height` is 480.5, not a number of pixels",
        ),
        (
            "=64\n",
            "=-1\n",
            "line 6: `ndisp` is -1, not a number of pixels",
        ),
        (
            "=100",
            "=inf",
            "line 3: `baseline` has the value inf, which is not finite",
        ),
    ] {
        let changed = text.replacen(from, to, 1);
        assert_ne!(changed, text, "{from}");
        assert_eq!(message(&changed), expected);
    }
}

/// Cameras before and after rectification stand in one world, so both need the rotation between
/// them.
#[test]
fn kittis_rectification_is_not_guessed() {
    let identity = "1 0 0 0 1 0 0 0 1";
    let text = format!(
        "K_00: 500 0 320 0 500 240 0 0 1\nR_00: {identity}\nT_00: 0 0 0\nR_rect_00: {identity}\n\
         P_rect_00: 500 0 320 0 0 500 240 0 0 0 1 0\n"
    );
    assert_eq!(decode(&text).unwrap().cameras.len(), 2);
    for (from, expected) in [
        (
            format!("R_rect_00: {identity}\n"),
            "line 1: there is no `R_rect_00`",
        ),
        (format!("R_00: {identity}\n"), "line 2: there is no `R_00`"),
        ("T_00: 0 0 0\n".to_owned(), "line 2: there is no `T_00`"),
    ] {
        let changed = text.replacen(&from, "", 1);
        assert_ne!(changed, text);
        assert_eq!(message(&changed), expected);
    }
}

#[test]
fn lenses_of_transforms_are_refused_by_name() {
    let text = "{\"w\": 640, \"h\": 480, \"fl_x\": 500,\n\"camera_model\": \"OPENCV\",\n\"k1\": 0.1,\n\
                \"frames\": [{\"file_path\": \"a.png\",\n\"transform_matrix\":\n\
                [[1,0,0,0],[0,1,0,0],[0,0,1,4],[0,0,0,1]]}]}";
    decode(text).unwrap();
    for (from, to, expected) in [
        (
            "OPENCV",
            "EQUIRECTANGULAR",
            "line 2: view 0: `camera_model` is \"EQUIRECTANGULAR\", which is not read",
        ),
        (
            "OPENCV",
            "THIN_PRISM_FISHEYE",
            "line 2: view 0: `camera_model` is \"THIN_PRISM_FISHEYE\", which is not read",
        ),
        (
            "OPENCV",
            "PINHOLE",
            "line 3: view 0: `k1` is not zero, as it is for a pinhole",
        ),
        (
            "k1",
            "k4",
            "line 3: view 0: `k4` is not zero: this term is not that of OpenCV",
        ),
        (
            "\"k1\": 0.1",
            "\"ftheta_p0\": 0.1",
            "line 3: view 0: `ftheta_p0` is a parameter of an",
        ),
        (
            "\"k1\": 0.1",
            "\"is_fisheye\": true",
            "line 3: view 0: `is_fisheye` is given, and also",
        ),
        (
            "\"k1\": 0.1",
            "\"is_fisheye\": 1",
            "line 3: view 0: `is_fisheye` is not true or false",
        ),
        ("\"h\": 480, ", "", "view 0: `h` is missing"),
        (
            "[0,0,1,4],[0,0,0,1]",
            "[0,0,1,0],[0,0,4,1]",
            "line 5: view 0: `transform_matrix` is not a rotation and a translation",
        ),
        (
            "[0,0,0,1]]",
            "[0,0,0]]",
            "line 5: view 0: `transform_matrix` is not four rows",
        ),
    ] {
        let changed = text.replacen(from, to, 1);
        assert_ne!(changed, text, "{from}");
        let found = message(&changed);
        assert!(found.contains(expected), "{found} does not say {expected}");
    }
}

/// The data of Blender state an angle of view and no size, which is that of the pictures.
#[test]
fn sizes_of_blenders_pictures_are_those_of_the_pictures() {
    let folder = tempdir().unwrap();
    let text = r#"{"camera_angle_x": 0.6911112070083618, "frames": [{"file_path": "./train/r_0",
        "transform_matrix": [[1,0,0,0],[0,1,0,0],[0,0,1,4],[0,0,0,1]]}]}"#;
    std::fs::write(folder.path().join("transforms.json"), text).unwrap();
    let error = format::read(folder.path()).unwrap_err().to_string();
    assert!(error.contains("`w` is not given, and the picture") && error.contains("r_0.png"));
    std::fs::create_dir(folder.path().join("train")).unwrap();
    let picture = image::GrayImage::new(800, 600);
    picture.save(folder.path().join("train/r_0.png")).unwrap();
    let file = format::read(folder.path()).unwrap();
    let camera = &file.cameras[0];
    assert_eq!(camera.size, Some([800, 600]));
    let intrinsics = camera.intrinsics().unwrap();
    // Half of the width at half of the angle; the middle of the first pixel is (0, 0).
    let focal = 400.0 / (0.5_f64 * 0.691_111_207_008_361_8).tan();
    assert!((intrinsics.focal()[0] - focal).abs() < 1e-9);
    assert_eq!(intrinsics.principal(), [399.5, 299.5]);
    // The camera is 4 above the origin and looks down at it.
    let seen = camera.camera().unwrap();
    let seen = seen
        .project(ga_runtime::cga3::Point::new(0.4, 0.2, 0.0))
        .unwrap();
    assert!((seen[0] - (399.5 + 0.1 * focal)).abs() < 1e-9, "{seen:?}");
    assert!((seen[1] - (299.5 - 0.05 * focal)).abs() < 1e-9, "{seen:?}");
    // A file that is no picture.
    std::fs::write(folder.path().join("train/r_0.png"), "none").unwrap();
    let error = format::read(folder.path()).unwrap_err().to_string();
    assert!(
        error.contains("r_0.png cannot be read") && !error.contains('\n'),
        "{error}"
    );
}

/// The video of a part of the sensor that the calibration does not know.
#[test]
fn sizes_of_qualisys_that_do_not_fit_are_refused() {
    let text = "<calibration><cameras><camera serial=\"a\" video_resolution=\"none\">\n\
                <fov_marker_max left=\"0\" top=\"0\" right=\"1919\" bottom=\"1087\"/>\n\
                <fov_video left=\"0\" top=\"0\" right=\"959\" bottom=\"543\"/>\n\
                <fov_video_max left=\"0\" top=\"0\" right=\"959\" bottom=\"543\"/>\n\
                <intrinsic focalLengthU=\"100000\" focalLengthV=\"100000\" centerPointU=\"61440\" \
                centerPointV=\"34816\" radialDistortion1=\"0\" radialDistortion2=\"0\" \
                radialDistortion3=\"0\" tangentalDistortion1=\"0\" tangentalDistortion2=\"0\"/>\n\
                </camera></cameras></calibration>";
    let found = decode(text).unwrap();
    // The middle of the sensor is the middle of the video.
    let intrinsics = found.cameras[0].intrinsics().unwrap();
    assert_eq!(intrinsics.principal(), [479.75, 271.75]);
    assert_eq!(intrinsics.focal(), [781.25; 2]);
    for (from, to, expected) in [
        (
            "right=\"959\" bottom=\"543\"/>\n<int",
            "right=\"959\" bottom=\"959\"/>\n<int",
            "line 1: `camera.fov_video_max` is 960 × 960 pixels, whose sides are not in the ratio of",
        ),
        (
            "none",
            "360p",
            "line 1: `camera.video_resolution` is not the lines of fov_video_max",
        ),
        (
            "left=\"0\" top=\"0\" right=\"959\"",
            "left=\"960\" top=\"0\" right=\"959\"",
            "line 3: `fov_video.right` is 0, not a number of pixels",
        ),
        (
            "focalLengthU=\"100000\"",
            "focalLengthU=\"0\"",
            "line 5: `intrinsic.focalLengthU`: focal lengths",
        ),
        (
            " centerPointV=\"34816\"",
            "",
            "line 5: there is no `intrinsic.centerPointV`",
        ),
    ] {
        let changed = text.replacen(from, to, 1);
        assert_ne!(changed, text, "{from}");
        let found = message(&changed);
        assert!(found.contains(expected), "{found} does not say {expected}");
    }
}
