//! What is identical, too small, or of other times and another size.

use ga_image::file;
use ga_image::plane::Plane;
use ga_image::y4m::{self, Film, Sampling};
use nullcone_shared_data::shared;
use serde_json::Value;
use tempfile::tempdir;

use super::{close, compare, report};
use crate::common::{assert_success, number, text};

#[test]
fn identity_is_claimed_of_all_channels_alone() {
    let Some(cases) = shared("cases/video") else {
        return;
    };
    let output = compare(&cases.join("colour-only"), ["a.png", "b.png", "--json"]);
    assert_success(&output);
    let object = report(&output);
    assert_eq!(
        (&object["identical"], &object["psnr"]),
        (&false.into(), &Value::Null)
    );
    assert_eq!(object["psnr_reason"], "luma is identical, colours differ");
    close(number(&object, "/psnr_all"), 11.9, 0.1);
    assert!(number(&object, "/ciede2000") > 20.0);
    let output = compare(&cases.join("colour-only"), ["a.png", "b.png"]);
    assert!(!text(&output.stdout).contains("nothing differs"));
    // The same picture turned by its EXIF, compressed again.
    let output = compare(&cases.join("rotation"), ["a.jpg", "b_exif3.jpg", "--json"]);
    assert_success(&output);
    assert!(number(&report(&output), "/psnr") > 35.0);
}

#[test]
fn small_pictures_have_psnr_and_no_ssim() {
    let folder = tempdir().unwrap();
    for (name, level) in [("a.png", 100), ("b.png", 101)] {
        file::write(
            folder.path().join(name),
            &Plane::filled(10, 30, level as u8),
        )
        .unwrap();
    }
    let arguments = [
        "a.png", "b.png", "--json", "--csv", "f.csv", "--report", "q.html",
    ];
    let output = compare(folder.path(), arguments);
    assert_success(&output);
    let object = report(&output);
    close(number(&object, "/psnr"), 20.0 * 255f64.log10(), 1e-9);
    for key in ["ssim", "attention_ssim"] {
        assert!(object[key].is_null());
        let reason = "10 × 30 pixels are too few, the window needs 11 × 11";
        assert_eq!(object[format!("{key}_reason")], reason);
    }
    let table = std::fs::read_to_string(folder.path().join("f.csv")).unwrap();
    let first = table.lines().next().unwrap();
    assert!(
        first.ends_with("psnr_6_1_1,psnr_all,ciede2000,distorted_frame"),
        "{first}"
    );
}

/// A film that begins three frames later and has twice the size.
#[test]
fn films_are_aligned_and_scaled() {
    let folder = tempdir().unwrap();
    let frame = |index: usize, factor: usize| {
        Plane::from_fn(40 * factor, 30 * factor, |x, y| {
            let (x, y) = (x / factor, y / factor);
            [((9 * x + 5 * y + 31 * index) % 256) as u8; 3]
        })
    };
    let film = Film {
        sampling: Sampling::Grey,
        ..Film::default()
    };
    let write = |name: &str, frames: std::ops::Range<usize>, factor: usize| {
        let path = folder.path().join(name);
        y4m::write(path, frames.map(|index| frame(index, factor)), film).unwrap();
    };
    write("a.y4m", 0..12, 1);
    write("b.y4m", 3..12, 2);
    let arguments = [
        "a.y4m",
        "b.y4m",
        "--align-times",
        "--scale",
        "--json",
        "--csv",
        "f.csv",
    ];
    let output = compare(folder.path(), arguments);
    assert_success(&output);
    let object = report(&output);
    assert_eq!(
        (&object["frames"], &object["identical_frames"]),
        (&9.into(), &9.into())
    );
    close(number(&object, "/alignment/offset_seconds"), 0.12, 1e-9);
    assert_eq!(object["alignment"]["unmatched_reference_frames"], 3);
    assert_eq!(object["scaled_from"], serde_json::json!([80, 60]));
    let said = text(&output.stderr);
    assert!(
        said.contains("+0.120 s") && said.contains("80 × 60 to 40 × 30"),
        "{said}"
    );
    let table = std::fs::read_to_string(folder.path().join("f.csv")).unwrap();
    let row = table.lines().nth(1).unwrap();
    assert!(
        row.starts_with("3,0.12,inf") && row.ends_with(",0"),
        "{row}"
    );
}
