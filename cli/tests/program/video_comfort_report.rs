//! The page of `nullcone video comfort --out`.

use std::path::Path;
use std::process::Stdio;

use ga_image::plane::Plane;
use ga_image::y4m::{self, Film};
use nullcone_shared_data::shared;
use tempfile::tempdir;

use crate::common::{assert_failure, assert_success, names, nullcone, program};

/// Random blocks of five pixels.
fn level(u: usize, v: usize) -> u8 {
    let block = (u / 5 + 1) * 7919 + (v / 5 + 1) * 104_729;
    (50 + block * block / 977 % 140) as u8
}

/// Where defects are.
const LOWER: std::ops::Range<usize> = 4..7;
const BRIGHTER: std::ops::Range<usize> = 9..12;
const FRAMES: usize = 14;

/// Both views beside each other. The upper half of the scene is on the screen, the lower one
/// somewhat in front of it. The right view is lower by three pixels, or brighter, in some frames.
fn frame(index: usize) -> Plane<[u8; 3]> {
    let moved = [0, 3, 8, 9, 4, 1, 2, 7][index % 8];
    let lower = if LOWER.contains(&index) { 3 } else { 0 };
    let brighter = if BRIGHTER.contains(&index) { 40 } else { 0 };
    Plane::from_fn(480, 136, |column, row| {
        let (is_right, column) = (column >= 240, column % 240);
        let row = if is_right { row + 40 - lower } else { row + 40 };
        let near = if is_right && row > 100 { 4 } else { 0 };
        let level = level(column + 2 * moved + near, row + moved);
        [level + if is_right { brighter } else { 0 }; 3]
    })
}

fn write(path: &Path, frames: usize, picture: impl Fn(usize) -> Plane<[u8; 3]>) {
    y4m::write(path, (0..frames).map(picture), Film::default()).unwrap();
}

const CLIP: [&str; 5] = ["video", "comfort", "clip.y4m", "--layout", "side-by-side"];

/// The page that the program writes for `clip.y4m`.
fn page(folder: &Path, more: &[&str]) -> String {
    let output = nullcone(folder, [&CLIP[..], &["--out", "page.html"], more].concat());
    assert_success(&output);
    std::fs::read_to_string(folder.join("page.html")).unwrap()
}

/// The texts of all elements of this name.
fn texts(page: &str, name: &str) -> Vec<String> {
    let (start, end) = (format!("<{name}"), format!("</{name}>"));
    // Headings have names, by which lists of contents lead to them.
    let parts = page.split(&start).skip(1);
    let parts = parts.filter(|part| part.starts_with('>') || part.starts_with(" id="));
    let parts = parts.map(|part| part.split(&end).next().unwrap().split_once('>').unwrap());
    parts.map(|(_, text)| text.to_owned()).collect()
}

/// Checks that pictures are XML, that each picture of pixels is inside the page, and that nothing
/// leads out of it. Returns how many pictures of pixels there are.
#[track_caller]
fn assert_self_contained(page: &str) -> usize {
    assert!(page.starts_with("<!DOCTYPE html>") && page.ends_with("</body></html>\n"));
    assert!(!page.contains("<script") && !page.contains("url(h") && !page.contains("@import"));
    let names = page.matches("xmlns=\"http://www.w3.org/2000/svg\"").count();
    assert_eq!(page.matches("http").count(), names);
    assert_eq!(page.matches("<svg").count(), names);
    let mut pictures = 0;
    for part in page.split("<svg").skip(1) {
        let (svg, _) = part.split_once("</svg>").unwrap();
        let svg = format!("<svg{svg}</svg>");
        let document = roxmltree::Document::parse(&svg).unwrap();
        for image in document
            .descendants()
            .filter(|node| node.has_tag_name("image"))
        {
            let source = image.attribute("href").unwrap();
            assert!(source.starts_with("data:image/"), "{source}");
            pictures += 1;
        }
        for node in document.descendants().filter(roxmltree::Node::is_element) {
            for attribute in node.attributes().filter(|found| found.name() != "href") {
                let value = attribute.value();
                assert!(!value.contains("NaN") && !value.contains("inf"), "{value}");
            }
        }
    }
    // Every element that is opened is closed.
    for name in [
        "table",
        "tr",
        "td",
        "th",
        "p",
        "h1",
        "h2",
        "h3",
        "div",
        "figure",
        "figcaption",
        "ol",
        "li",
    ] {
        let opened =
            page.matches(&format!("<{name}>")).count() + page.matches(&format!("<{name} ")).count();
        assert_eq!(
            opened,
            page.matches(&format!("</{name}>")).count(),
            "{name}"
        );
    }
    pictures
}

#[test]
fn defects_are_named_with_their_frames() {
    let folder = tempdir().unwrap();
    write(&folder.path().join("clip.y4m"), FRAMES, frame);
    let page = page(folder.path(), &[]);
    // The depth, and a worst moment at least for two rows.
    assert!(assert_self_contained(&page) >= 4);
    let worst = |name: &str| -> usize {
        let titles = texts(&page, "h3");
        let title = titles.iter().find(|title| title.starts_with(name));
        let title = title.unwrap_or_else(|| panic!("{name} is not in {titles:?}"));
        let (_, rest) = title.split_once("(frame ").unwrap();
        rest.split(')').next().unwrap().parse().unwrap()
    };
    assert!(LOWER.contains(&worst("Vertical misalignment")));
    assert!(BRIGHTER.contains(&worst("Difference of brightness")));
    // 25 frames in a second: frame 4 is the first of these.
    assert!(page.contains("00:00:00:04 (4)"));
    assert!(page.contains("in 3 of 14 frames"));
    assert!(page.contains("the right view is 3.0 pixels lower"));
    assert!(page.contains("nullcone video align clip.y4m --layout side-by-side --out aligned.y4m"));
    assert!(page.contains("Good in all frames: equal colours"));
    // The table has a row for each quantity below its heading.
    let tables = texts(&page, "table");
    assert_eq!(tables.len(), 2);
    assert!(
        tables
            .iter()
            .all(|table| table.matches("<tr>").count() == 12)
    );
    // Three of 14 frames are 21 %.
    let brightness = tables[0]
        .lines()
        .find(|line| line.contains("Difference of brightness"));
    assert!(brightness.unwrap().contains(">21 %<"), "{brightness:?}");
}

#[test]
fn bytes_do_not_depend_on_threads() {
    let folder = tempdir().unwrap();
    write(&folder.path().join("clip.y4m"), FRAMES, frame);
    let two = page(folder.path(), &["--quiet"]);
    assert_eq!(page(folder.path(), &["--threads", "1"]), two);
    // Rows are printed as without the page.
    let output = nullcone(
        folder.path(),
        [&CLIP[..], &["--json", "--out", "page.html"]].concat(),
    );
    let plain = nullcone(folder.path(), [&CLIP[..], &["--json"]].concat());
    assert_success(&output);
    assert_eq!(output.stdout, plain.stdout);
    // The same video from a pipe differs in its name and in what can be done with it.
    let clip = std::fs::File::open(folder.path().join("clip.y4m")).unwrap();
    let arguments = [
        "video",
        "comfort",
        "-",
        "--layout",
        "side-by-side",
        "--out",
        "pipe.html",
    ];
    let output = program(folder.path())
        .args(arguments)
        .stdin(Stdio::from(clip))
        .output()
        .unwrap();
    assert_success(&output);
    let piped = std::fs::read_to_string(folder.path().join("pipe.html")).unwrap();
    assert_self_contained(&piped);
    assert_eq!(texts(&piped, "h1"), ["Viewing comfort of standard input"]);
    assert_eq!(texts(&piped, "h3"), texts(&two, "h3"));
    assert_eq!(
        piped.matches("data:image").count(),
        two.matches("data:image").count()
    );
    assert!(!piped.contains("aligned.y4m") && piped.contains("if the video is in a file"));
}

#[test]
fn a_name_is_text_in_the_page_and_one_word_in_the_command() {
    let folder = tempdir().unwrap();
    let name = "a <b> & 'c'.y4m";
    write(&folder.path().join(name), FRAMES, frame);
    let arguments = [
        "video",
        "comfort",
        name,
        "--layout",
        "side-by-side",
        "--out",
        "p.html",
    ];
    assert_success(&nullcone(folder.path(), arguments));
    let page = std::fs::read_to_string(folder.path().join("p.html")).unwrap();
    assert_self_contained(&page);
    assert_eq!(
        texts(&page, "h1"),
        ["Viewing comfort of a &lt;b&gt; &amp; &#39;c&#39;.y4m"]
    );
    let in_html = |text: &str| text.replace('\'', "&#39;");
    let command = in_html("align 'a &lt;b&gt; &amp; '\\''c'\\''.y4m' --layout");
    assert!(page.contains(&command));
}

#[test]
fn a_video_that_breaks_off_has_a_page_with_a_warning() {
    let folder = tempdir().unwrap();
    let path = folder.path().join("clip.y4m");
    write(&path, FRAMES, frame);
    let mut bytes = std::fs::read(&path).unwrap();
    bytes.truncate(bytes.len() - 500);
    std::fs::write(&path, bytes).unwrap();
    let output = nullcone(
        folder.path(),
        [&CLIP[..], &["--out", "page.html", "--quiet"]].concat(),
    );
    assert_failure(&output, &["within frame 13"]);
    let page = std::fs::read_to_string(folder.path().join("page.html")).unwrap();
    assert_self_contained(&page);
    let (_, warning) = page.split_once("<p class=\"warning\">").unwrap();
    let warning = warning.split("</p>").next().unwrap();
    assert!(warning.contains("within frame 13") && warning.contains("13 frames before"));
    assert!(page.contains("The video has 13 frames"));
    // Nothing else is left behind.
    assert_eq!(names(folder.path()), ["clip.y4m", "page.html"]);
}

#[test]
fn bad_places_are_refused_before_the_work() {
    let folder = tempdir().unwrap();
    std::fs::create_dir(folder.path().join("folder.html")).unwrap();
    // There is no video: what is wrong with the page is seen first.
    for (out, message) in [
        ("page.pdf", "must end in .html or .htm"),
        ("page", "must end in .html or .htm"),
        ("folder.html", "is a directory"),
    ] {
        let output = nullcone(folder.path(), [&CLIP[..], &["--out", out]].concat());
        assert_failure(&output, &[out, message]);
    }
    // A page without frames is not written.
    write(&folder.path().join("mono.y4m"), 2, |_| {
        Plane::from_fn(480, 136, |column, row| [(column / 3 + row) as u8; 3])
    });
    let arguments = [
        "video",
        "comfort",
        "left.y4m",
        "right.y4m",
        "--out",
        "page.html",
    ];
    write(&folder.path().join("left.y4m"), 2, |_| {
        Plane::filled(40, 30, [9; 3])
    });
    write(&folder.path().join("right.y4m"), 2, |_| {
        Plane::filled(44, 30, [9; 3])
    });
    assert_failure(&nullcone(folder.path(), arguments), &["differ in size"]);
    let expected = ["folder.html", "left.y4m", "mono.y4m", "right.y4m"];
    assert_eq!(names(folder.path()), expected);
}

/// Views that show nothing, of few pixels, one frame only.
#[test]
fn a_page_about_nothing_is_a_page() {
    let folder = tempdir().unwrap();
    for [width, height] in [[2, 1], [16, 8], [64, 48]] {
        write(&folder.path().join("clip.y4m"), 1, |_| {
            Plane::filled(width, height, [90; 3])
        });
        let page = page(folder.path(), &[]);
        assert!(assert_self_contained(&page) <= 1);
        let text = "Nothing could be measured in this video.</p>";
        assert!(page.contains(text) && page.contains("The video has one frame of"));
    }
}

/// Each interval of the clip has one injected defect, whose frames are named.
#[test]
fn defects_of_a_real_clip_are_shown() {
    let path = "data/vision/clips/motorcycle_sbs_960x324_defects.y4m";
    let Some(path) = shared(path) else { return };
    let folder = tempdir().unwrap();
    let path = path.to_str().unwrap();
    let arguments = [
        "video",
        "comfort",
        path,
        "--layout",
        "side-by-side",
        "--out",
        "page.html",
    ];
    assert_success(&nullcone(folder.path(), arguments));
    let page = std::fs::read_to_string(folder.path().join("page.html")).unwrap();
    assert_self_contained(&page);
    let titles = texts(&page, "h3");
    for (name, frames) in [
        ("Vertical misalignment", 8..14),
        ("Difference of brightness", 14..20),
        ("Difference of colour", 20..26),
        ("Exchanged views", 26..32),
        ("Difference of sharpness", 32..38),
        ("Too far in front", 38..43),
        ("Too far behind", 43..48),
    ] {
        let found = titles.iter().find_map(|title| {
            let rest = title.strip_prefix(name)?.split_once("(frame ")?.1;
            rest.split(')').next()?.parse::<usize>().ok()
        });
        assert!(
            found.is_some_and(|frame| frames.contains(&frame)),
            "{name} {found:?}"
        );
    }
    assert!(page.contains("Mend first: exchanged views, in 6 of 48 frames"));
}
