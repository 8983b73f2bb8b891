//! Films as H.264 in MP4.

use tempfile::{TempDir, tempdir};

use crate::common::{assert_success, nullcone};

/// A folder with the figure that the program makes in `out`.
fn walk() -> TempDir {
    let folder = tempdir().unwrap();
    assert_success(&nullcone(folder.path(), ["demo", "--figure"]));
    folder
}

#[cfg(not(feature = "mp4"))]
#[test]
fn without_its_feature_a_film_in_mp4_is_refused_with_what_helps() {
    use crate::common::{assert_failure, names};

    let folder = walk();
    let before = names(folder.path());
    let render = "render out/model.glb --animation walk --film film.mp4";
    for command in [render, "demo --figure --film film.mp4 --out other"] {
        let output = nullcone(folder.path(), command.split(' '));
        assert_failure(
            &output,
            &[
                "--film film.mp4",
                "--features mp4",
                "ffmpeg -i film.y4m film.mp4",
            ],
        );
    }
    assert_eq!(names(folder.path()), before);
}

#[cfg(feature = "mp4")]
mod with_its_feature {
    use ga_image::plane::Plane;
    use ga_video::{Frame, open};

    use super::*;
    use crate::common::{json, text};

    /// The pictures of a film, and its rate.
    fn pictures(folder: &TempDir, name: &str) -> (Vec<Plane<[u8; 3]>>, Option<[u32; 2]>) {
        let mut source = open(folder.path().join(name)).unwrap();
        let properties = *source.properties();
        let (mut pictures, mut frame) = (Vec::new(), Frame::default());
        while source.read(&mut frame).unwrap() {
            pictures.push(frame.to_rgb(properties.colours));
        }
        (pictures, properties.frames_per_second)
    }

    /// PSNR of two pictures in dB.
    fn psnr(a: &Plane<[u8; 3]>, b: &Plane<[u8; 3]>) -> f64 {
        let pairs = a
            .values()
            .as_flattened()
            .iter()
            .zip(b.values().as_flattened());
        let squares = pairs.map(|(a, b)| (f64::from(*a) - f64::from(*b)).powi(2));
        let count = a.values().as_flattened().len() as f64;
        10.0 * (255.0f64.powi(2) * count / squares.sum::<f64>()).log10()
    }

    #[test]
    fn a_film_in_mp4_shows_what_one_without_compression_does() {
        let folder = walk();
        let render = "render out/model.glb --animation walk --size 160x120 --ground --rate 12.5";
        for film in ["render.y4m", "render.mp4"] {
            let command = format!("{render} --film {film}");
            let report = json(folder.path(), &command.split(' ').collect::<Vec<_>>());
            assert_eq!(report["warnings"], serde_json::json!([]));
        }
        for film in ["demo.y4m", "demo.mp4"] {
            let command = format!("demo --figure --film {film}");
            assert_success(&nullcone(folder.path(), command.split(' ')));
        }
        for (name, rate) in [("render", [25, 2]), ("demo", [88, 3])] {
            let [plain, small] = ["y4m", "mp4"].map(|ending| format!("{name}.{ending}"));
            let (expected, found) = (pictures(&folder, &plain), pictures(&folder, &small));
            assert_eq!((expected.1, found.1), (Some(rate), Some(rate)));
            assert_eq!(expected.0.len(), found.0.len());
            for (number, (a, b)) in expected.0.iter().zip(&found.0).enumerate() {
                let found = psnr(a, b);
                assert!(found > 38.0, "{name} {number}: {found} dB");
            }
            let length = |name: &str| std::fs::metadata(folder.path().join(name)).unwrap().len();
            assert!(30 * length(&small) < length(&plain), "{}", length(&small));
        }
    }

    #[test]
    fn odd_sizes_are_made_even_with_a_warning() {
        let folder = walk();
        let render = "render out/model.glb --turntable 3 --size 65x49 --out film.mp4";
        let output = nullcone(folder.path(), render.split(' '));
        assert_success(&output);
        let said = text(&output.stderr);
        assert!(
            said.contains("film.mp4") && said.contains("66 × 50"),
            "{said}"
        );
        let (pictures, rate) = pictures(&folder, "film.mp4");
        assert_eq!((pictures.len(), rate), (3, Some([25, 1])));
        assert_eq!([pictures[0].width(), pictures[0].height()], [66, 50]);
        let large = "render out/model.glb --size 3900x20 --turntable 2 --out film.mp4";
        let output = nullcone(folder.path(), large.split(' '));
        assert_eq!(output.status.code(), Some(1));
        let said = text(&output.stderr);
        assert!(said.contains("3900 × 20"), "{said}");
    }
}
