//! The tables of the paper, with its numbers beside those of the demonstration.

use anyhow::Result;
use ga_draw::document::{Cell, Page, Tint};
use ga_video::comfort::monitor::{Options, analyse};
use ga_video::comfort::{Dimension, Level, Record, Score, Viewing};
use ga_video::stereo::{Layout, StereoSource};

use super::run::Run;
use super::scores::Scores;
use super::steps::{SKIN, STATISTICS, SUBDIVISION};

/// Cui, table 1: shots, those with a static and those with a dynamic background.
const SHOTS: [(&str, [u32; 3]); 4] = [
    ("Disney animation", [559, 336, 223]),
    ("Japanese animation", [312, 182, 130]),
    ("Chinese animation", [388, 221, 167]),
    ("total", [1259, 739, 520]),
];
/// Cui, table 2: errors after an alignment, in millimetres.
const ALIGNED: [(&str, f64); 6] = [
    ("SMPLify", 82.2),
    ("NBF", 60.2),
    ("GraphCMR", 76.2),
    ("SPIN", 94.0),
    ("METRO", 87.2),
    ("Cui", 57.2),
];
/// Cui, table 3: errors without it.
const JOINTS: [(&str, f64); 6] = [
    ("NeRF", 88.57),
    ("SMPL", 87.59),
    ("VIBE", 80.35),
    ("Deep Kinematic Pose", 106.95),
    ("HMR", 87.54),
    ("Cui", 85.23),
];
/// Cui, table 4: vertices and faces before and after subdivision.
const FACES: [(&str, [u64; 2]); 2] = [("model", [6899, 13_778]), ("refined", [27_654, 56_217])];
/// Cui, table 5: seconds to make a texture.
const SECONDS: [(&str, f64); 4] = [
    ("body 1", 16.3),
    ("body 2", 17.6),
    ("body 3", 15.2),
    ("mean", 16.8),
];
/// Cui, table 6: the frames, and the scores of all dimensions in them.
const FRAMES: [usize; 2] = [6, 24];
const COMFORT: [[u8; 19]; 11] = [
    [7, 7, 7, 7, 7, 8, 8, 8, 8, 8, 8, 8, 8, 8, 8, 9, 8, 8, 9],
    [5; 19],
    [0, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 3, 5, 5, 5, 5, 5, 7, 5],
    [0; 19],
    [0, 0, 0, 0, 2, 0, 0, 0, 2, 0, 0, 1, 0, 2, 4, 4, 0, 0, 0],
    [0; 19],
    [0; 19],
    [2, 8, 8, 8, 8, 8, 8, 8, 8, 8, 8, 8, 8, 8, 7, 8, 8, 8, 8],
    [0, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 5, 2, 3, 3, 3, 3],
    [8, 8, 8, 8, 8, 8, 8, 8, 8, 8, 7, 7, 7, 7, 7, 7, 7, 7, 7],
    [0, 9, 6, 6, 6, 6, 6, 7, 7, 6, 6, 6, 7, 7, 6, 5, 8, 8, 8],
];

/// What stands where a time is to be, until the script beside the page writes it.
const MISSING: &str = "in times.js, which is not beside this page";

/// Tables 1 to 6.
pub(super) fn tables(page: &mut Page, run: &Run, scores: &Scores) -> Result<()> {
    page.subheading("Table 1: shots by their background");
    let number = |key: &str| run.number(STATISTICS, &format!("/total/{key}"));
    let own = [number("shots")?, number("static")?, number("dynamic")?];
    let printed = SHOTS.map(|(name, counts)| (name, counts.map(f64::from)));
    let rows = printed
        .into_iter()
        .chain([("both films of this page", own)]);
    page.table(
        [
            "",
            "shots",
            "static background",
            "dynamic background",
            "static",
        ],
        rows.map(|(name, [shots, fixed, moving])| {
            [
                name.to_owned(),
                shots.to_string(),
                fixed.to_string(),
                moving.to_string(),
                format!("{:.2} %", 100.0 * fixed / shots),
            ]
        }),
    );
    page.paragraph(
        "The paper counts shots of animated films; here are the two films of this page.",
    );

    let joints = &scores.joints;
    let own = "here, from two films with dots";
    page.subheading("Table 2: errors after an alignment");
    errors(page, &ALIGNED, (own, joints.aligned_error_millimetres));
    page.subheading("Table 3: mean distance of joints (MPJPE)");
    errors(
        page,
        &JOINTS,
        (own, joints.mean_per_joint_position_error_millimetres),
    );
    page.paragraph(
        "The paper's numbers are those of Human3.6M, where methods see one picture of a person \
         without dots. Here two calibrated cameras see a figure with dots on its skin, so that the \
         numbers cannot be compared as methods: they show how near the way back comes to the truth.",
    );

    page.subheading("Table 4: subdivision");
    let printed = FACES.map(|(name, counts)| {
        let [vertices, faces] = counts.map(|count| count.to_string());
        [format!("Cui, {name}"), vertices, faces]
    });
    let own = |step: &str, name: &str| -> Result<[String; 3]> {
        let [vertices, faces] = ["/vertices", "/faces"].map(|key| run.number(step, key));
        Ok([
            format!("here, {name}"),
            vertices?.to_string(),
            faces?.to_string(),
        ])
    };
    let (before, after) = (own(SKIN, "model")?, own(SUBDIVISION, "refined")?);
    page.table(
        ["", "vertices", "faces"],
        printed.into_iter().chain([before, after]),
    );
    page.paragraph(
        "A step of Loop's scheme makes V + E vertices and 4 F faces: 55 112 faces of 13 778, where the \
         paper prints 56 217.",
    );
    times(page);
    comfort(page)
}

/// Figure 10, whose times are in the file beside the page.
pub(super) fn reconstruction_times(page: &mut Page) {
    page.subheading("Figure 10: time to reconstruct");
    page.table_to_fill(
        ["here", "time"],
        [
            ("depth of a pair of pictures", "disparities"),
            ("joints by dots, all frames of two views", "dots"),
            ("the body, all frames", "people"),
            ("a motor moves a point", "motor"),
            ("an affine matrix of the crate glam moves a point", "glam"),
        ],
        MISSING,
    );
    page.paragraph(
        "Times are measured anew on each run, and are the only thing here that differs from run to \
         run. The paper draws figure 10 without numbers.",
    );
}

fn errors<const N: usize>(page: &mut Page, printed: &[(&str, f64); N], own: (&str, f64)) {
    let rows = printed.iter().copied().chain([own]);
    page.table(
        ["method", "mm"],
        rows.map(|(name, error)| [name.to_owned(), format!("{error:.2}")]),
    );
}

/// Table 5, whose times are in the file beside the page.
fn times(page: &mut Page) {
    page.subheading("Table 5: time to make the maps");
    let rows = SECONDS.map(|(name, seconds)| [format!("Cui, {name}"), format!("{seconds} s")]);
    page.table(["", "time"], rows);
    page.table_to_fill(
        ["here", "time"],
        [
            ("texture from the views", "texture"),
            ("maps of normals and displacement", "maps"),
        ],
        MISSING,
    );
    page.paragraph("The printed mean is 16.8 s; that of the three printed times is 16.4 s.");
}

/// Table 6, of the film after its alignment.
fn comfort(page: &mut Page) -> Result<()> {
    let film = ga_video::open("aligned.y4m")?;
    let mut source = StereoSource::halves(film, Layout::SideBySide)?;
    let options = Options {
        viewing: Viewing::default(),
        layout: Some(Layout::SideBySide),
        threads: rayon::current_num_threads(),
    };
    let mut records: Vec<Record> = Vec::new();
    analyse(&mut source, options, |record| records.push(record))?;
    page.subheading("Table 6: comfort, frame by frame");
    let [first, last] = FRAMES;
    let names: [String; 20] = std::array::from_fn(|column| match column {
        0 => "frame".to_owned(),
        _ => (first + column - 1).to_string(),
    });
    let rows = Dimension::ALL
        .iter()
        .zip(COMFORT)
        .flat_map(|(dimension, printed)| {
            let name = dimension.in_words();
            let own = records.iter().skip(first).take(last + 1 - first);
            let own = own.map(|record| match record.row(*dimension).score {
                Ok(score) => Cell {
                    text: score.to_string(),
                    tint: Some(tint(score.level())),
                },
                Err(_) => Cell {
                    text: "–".to_owned(),
                    tint: Some(Tint::Grey),
                },
            });
            let own: Vec<Cell> = own.collect();
            let printed = printed.map(|score| Cell {
                text: score.to_string(),
                tint: Some(tint(Score::new(score).level())),
            });
            [
                row(format!("{name}, Cui"), printed.to_vec()),
                row(format!("{name}, here"), own),
            ]
        });
    page.tinted_table(names.each_ref().map(String::as_str), rows);
    page.paragraph(
        "The paper measured 120 seconds of another film by another program. A dash is a score that \
         cannot be known: a person before a still wall does not tell by itself how late one eye is.",
    );
    Ok(())
}

fn row(name: String, cells: Vec<Cell>) -> [Cell; 20] {
    let mut cells = cells.into_iter();
    std::array::from_fn(|column| match column {
        0 => Cell::from(name.clone()),
        _ => cells.next().unwrap_or_else(|| Cell::from(String::new())),
    })
}

fn tint(level: Level) -> Tint {
    match level {
        Level::Green => Tint::Green,
        Level::Orange => Tint::Orange,
        Level::Red => Tint::Red,
    }
}

/// Where the figures of the paper are on the page.
pub(super) const FIGURES: [[&str; 2]; 7] = [
    [
        "1: rays of two cameras that meet",
        "the steps “Surface” and “The surface from aside”",
    ],
    [
        "6: difference of the background and mutual information",
        "the curves of the step “Key frames”",
    ],
    ["7, 8: in-between frames", "the sheet above"],
    [
        "9: error of joints in pictures",
        "the chart of each view below the films, in pixels; the paper states differences in mm alone",
    ],
    [
        "10: time to reconstruct",
        "the table below; the paper draws it without numbers",
    ],
    [
        "11: opinion of 20 people",
        "nobody was asked about these films: `nullcone quality ratings` evaluates such a table",
    ],
    [
        "12: scores of people over measures",
        "the measures are in the step “Quality of the film”; without scores of people there is no \
         curve, which `nullcone quality fit` makes of a table",
    ],
];
