//! The page of the demonstration.

use std::path::Path;

use anyhow::{Context as _, Result};
use ga_anim::clip::Clip;
use ga_anim::skin::Method;
use ga_character::Figure;
use ga_draw::document::{Encoding, ModelCoordinates, ModelTexture, ModelView, Page};
use ga_image::png;
use serde_json::Value;

use super::algebra::{LegBothWays, Level, Weights};
use super::findings::finding;
use super::inputs::FRAMES;
use super::paper;
use super::run::{Done, Run};
use super::scores::Scores;
use super::steps::{
    ALIGNED, COMFORT, DISPARITIES, EVALUATION, KEY_FRAMES, MAPS, PEOPLE, QUALITY, RECTIFICATION,
    SURFACE_VIEW, TEXTURED_VIEW,
};
use super::studio::FRAMES_PER_SECOND;
use super::times;

/// What the page shows.
pub(super) struct Contents<'a> {
    pub(super) figure: &'a Figure,
    pub(super) clip: &'a Clip,
    pub(super) run: &'a Run,
    pub(super) scores: &'a Scores,
    pub(super) leg: Option<&'a LegBothWays>,
    pub(super) levels: &'a [Level],
    pub(super) weights: &'a Weights,
}

/// The page, made in the folder of the results.
pub(super) fn page(contents: &Contents<'_>) -> Result<Page> {
    let Contents { run, scores, .. } = contents;
    let mut page = Page::new("Nullcone: from films to a moving person");
    page.paragraph(
        "A figure with dots on its skin moves in a room before two cameras. From their films, \
         and from pictures of a chessboard, the commands on this page find the cameras, the depth, \
         the joints and the body again: as points, lines, planes, circles and motors of conformal \
         geometric algebra.",
    );
    score_table(&mut page, scores);
    model(&mut page, contents)?;
    page.contents();

    page.heading("What is filmed, and what is known");
    page.paragraph(
        "The right picture is too bright and rolled a little, and both have noise. The commands are \
         told where the dots are on the figure at rest, how large the squares of the chessboard are, \
         about where the disc on the wall is in both pictures, where in the room the left camera \
         stands, and that the floor is at y = 0. What else the films were made of is used for the scores alone.",
    );
    page.paragraph(
        "“Cui” is the paper behind these steps: Y. Cui, Geometric Algebra-Based Modeling Techniques \
         for 3D Animation and Their Application to Visual Communication. In formulas, products of blades are geometric, ∧ is the outer product, · the inner \
         one, ~M the reverse of M, and e∞ the point at infinity.",
    );
    page.heading("The films, and the body that was found in them");
    if let Some(people) = run.said(PEOPLE)?.page.clone() {
        page.include(people);
    }
    page.heading("Every step");
    page.paragraph(
        "All of these commands ran in the folder of this page, one after the other, and can be run \
         there again by hand.",
    );
    for done in &run.steps {
        step(&mut page, done, run, scores)?;
    }
    algebra(&mut page, contents);
    page.heading("The tables of the paper");
    paper::tables(&mut page, run, scores)?;
    page.heading("The figures of the paper");
    let mut sheet = Page::new("Figures 7 and 8");
    picture(
        &mut sheet,
        "Key frames of the motion, and three in-between frames after each",
        "sheet.png",
    )?;
    page.fold("Figures 7 and 8: key frames and in-between frames", sheet);
    page.text_table(
        ["figure", "here"],
        paper::FIGURES.map(|row| row.map(str::to_owned)),
    );
    paper::reconstruction_times(&mut page);
    page.script_beside(times::FILE);
    Ok(page)
}

/// What a step does, its formula, what it found, and its command.
fn step(page: &mut Page, done: &Done, run: &Run, scores: &Scores) -> Result<()> {
    let step = done.step;
    page.subheading_from(step.title, &format!("Cui, {}", step.section));
    page.paragraph(step.does);
    page.formula(step.formula);
    match (step.name, finding(step.name, run, scores)?) {
        (COMFORT, Some(text)) if !scores.uncomfortable_before.is_empty() => page.warning(&text),
        (ALIGNED, Some(text)) if !scores.uncomfortable_after.is_empty() => page.warning(&text),
        (_, Some(text)) => page.note(&text),
        (_, None) => {}
    }
    match step.name {
        RECTIFICATION => pictures(
            page,
            [
                ("The left picture, rectified", "rectified/left.png"),
                (
                    "The right one: each point is in the same row",
                    "rectified/right.png",
                ),
            ],
        )?,
        DISPARITIES => picture(page, "The disparity of each pixel", "disparity.png")?,
        EVALUATION => picture(
            page,
            "Left what was found, in the middle the truth, both yellow where it is near; right their \
             difference, dark where there is none",
            "errors.png",
        )?,
        SURFACE_VIEW => picture(page, "The surface, seen from aside", "surface.png")?,
        KEY_FRAMES => {
            picture(page, "Key frames of the left film", "keys.png")?;
            curves(
                page,
                "The curves of figure 6, of the left film.",
                "curves.svg",
            )?;
        }
        QUALITY => curves(page, "The measures over time.", "quality.svg")?,
        TEXTURED_VIEW => picture(
            page,
            "The figure with the texture that was found",
            "textured.png",
        )?,
        MAPS => pictures(
            page,
            [
                ("Normals of the fine surface", "baked/normal.png"),
                ("Its height over the coarse one", "baked/displacement.png"),
            ],
        )?,
        _ => {}
    }
    page.code(&in_lines(&done.command()));
    if !step.files.is_empty() {
        page.files(step.files.iter().copied());
    }
    match done.said.page.clone() {
        _ if step.name == PEOPLE => {}
        Some(own) => page.fold(&format!("The page of {}", words(step.line)), own),
        None => {
            let numbers = numbers(&done.said.values);
            if !numbers.is_empty() {
                let mut table = Page::new("Numbers");
                table.table(["", ""], numbers);
                page.fold("All numbers", table);
            }
        }
    }
    Ok(())
}

/// A command in lines that a shell joins, of which each begins with an option.
fn in_lines(command: &str) -> String {
    const MOST: usize = 90;
    let mut lines = String::new();
    let mut length = 0;
    for (number, part) in command.split(" --").enumerate() {
        let part = match number {
            0 => part.to_owned(),
            _ => format!(" --{part}"),
        };
        if number > 0 && length + part.len() > MOST {
            lines += " \\\n   ";
            length = 3;
        }
        length += part.len();
        lines += &part;
    }
    lines
}

/// The words by which a command is called.
fn words(line: &str) -> String {
    let words = line
        .split(' ')
        .take_while(|word| !word.contains(['/', '.', '-']));
    format!("nullcone {}", words.collect::<Vec<_>>().join(" "))
}

/// The single values that a command says; lists are in `report.json`.
fn numbers(values: &Value) -> Vec<[String; 2]> {
    let all = values.as_object().into_iter().flatten();
    let single = all.filter_map(|(name, value)| {
        let text = match value {
            Value::Number(number) if number.is_f64() => {
                number.as_f64().map(rounded).unwrap_or_default()
            }
            Value::Number(number) => number.to_string(),
            Value::String(text) => text.clone(),
            Value::Bool(is) => is.to_string(),
            _ => return None,
        };
        Some([name.replace('_', " "), text])
    });
    single.collect()
}

/// A number of four digits.
fn rounded(number: f64) -> String {
    match number.abs() {
        0.0 => "0".to_owned(),
        ..1e-4 => format!("{number:.3e}"),
        size => {
            let decimals = (3.0 - size.log10().floor()).max(0.0) as usize;
            format!("{number:.decimals$}")
        }
    }
}

/// The scores that something is asked of.
fn score_table(page: &mut Page, scores: &Scores) {
    let goals = scores.goals();
    if goals.iter().all(|goal| goal.is_reached) {
        page.note("All five goals are reached.");
    } else {
        page.warning("A goal is missed.");
    }
    let rows = goals.into_iter().map(|goal| {
        let mark = if goal.is_reached { "✓" } else { "missed" };
        [
            goal.name.to_owned(),
            goal.found,
            goal.asked.to_owned(),
            mark.to_owned(),
        ]
    });
    page.table(["", "found", "goal", ""], rows);
}

/// The moving figure, which the mouse turns.
fn model(page: &mut Page, contents: &Contents<'_>) -> Result<()> {
    let Contents { figure, clip, .. } = contents;
    let character = &figure.character;
    let mesh = &character.mesh;
    let frames = (0..FRAMES).map(|frame| {
        let pose = clip.sample(frame as f64 / f64::from(FRAMES_PER_SECOND));
        Ok(character.skinned(&pose, Method::Motor)?)
    });
    let texture = figure.paint.as_ref().zip(mesh.texture_coordinates());
    let texture = texture.map(|(paint, coordinates)| -> Result<ModelTexture> {
        let corners = mesh.corner_triangles().into_iter().map(|corners| {
            corners.map(|corner| {
                coordinates
                    .get(corner as usize)
                    .copied()
                    .unwrap_or_default()
            })
        });
        Ok(ModelTexture {
            coordinates: ModelCoordinates::Corners(corners.collect()),
            encoding: Encoding::Png,
            bytes: png::encode(paint)?,
        })
    });
    let view = ModelView {
        triangles: mesh.triangles(),
        frames: frames.collect::<Result<_>>()?,
        frames_per_second: f64::from(FRAMES_PER_SECOND),
        texture: texture.transpose()?,
        floor: Some(0.0),
        ..ModelView::default()
    };
    page.model(
        &view,
        "The figure that was filmed, without its dots: the truth, not what was found. It is skinned \
         by motors: x′ = G x ~G with the motor G that is the weighted mean of those of the bones.",
    )?;
    Ok(())
}

fn picture(page: &mut Page, words: &str, file: &str) -> Result<()> {
    let bytes = std::fs::read(Path::new(file)).with_context(|| file.to_owned())?;
    page.pictures([(words, bytes.as_slice())]);
    Ok(())
}

/// Two pictures beside each other.
fn pictures(page: &mut Page, both: [(&'static str, &'static str); 2]) -> Result<()> {
    let read = |(words, file): (&'static str, &'static str)| -> Result<_> {
        Ok((words, std::fs::read(file).with_context(|| file.to_owned())?))
    };
    let [left, right] = both.map(read);
    let (left, right) = (left?, right?);
    page.pictures([(left.0, left.1.as_slice()), (right.0, right.1.as_slice())]);
    Ok(())
}

fn curves(page: &mut Page, words: &str, file: &str) -> Result<()> {
    let svg = std::fs::read_to_string(file).with_context(|| file.to_owned())?;
    page.wide_svg(&svg, words);
    Ok(())
}

/// What the paper computes with the joints and the depth.
fn algebra(page: &mut Page, contents: &Contents<'_>) {
    let Contents {
        leg,
        levels,
        weights,
        ..
    } = contents;
    page.heading("The algebra of the paper, on what was found");
    match leg {
        Some(leg) => leg_both_ways(page, leg),
        None => page.note("Which joints are a leg is not clear, so that none is solved."),
    }
    page.subheading_from("Modelling points at several levels", "Cui, §2.1.2, eq. 2");
    page.paragraph(
        "From level to level, four points become one. The depth is that of the disparity d. K is the \
         paper's predicted distance, in pixels, with the disparity as S and the distance between \
         points of the level as Q; φ = 10, t = 1 and C = 0.5 are left open by the paper. K is no \
         depth, and nothing here depends on it.",
    );
    page.formula("Z = f B / (d + c_right − c_left)");
    page.formula("K = φ² Q (1 − C) / (S Q + t) − S");
    page.table(
        ["level", "points", "disparity, px", "depth, m", "± m", "K"],
        levels.iter().map(|level| {
            [
                level.level.to_string(),
                level.points.to_string(),
                format!("{:.2}", level.disparity_px),
                format!("{:.4}", level.depth_metres),
                format!("{:.4}", level.depth_deviation_metres),
                format!("{:.3}", level.predicted_distance),
            ]
        }),
    );
    page.paragraph("Numbers are those of the point that is nearest to the middle of the picture.");
    page.subheading_from("Skin weights by distance", "Cui, eq. 33");
    page.paragraph(
        "How much a vertex follows a bone may be told by its distance L from the bone alone, here \
         beside the weights that the figure has.",
    );
    page.formula("wᵢ = Lᵢ⁻ᵐ / Σ Lₖ⁻ᵐ, over the n nearest bones");
    page.note(&format!(
        "With n = {} and m = {}, {:.1} % of the {} vertices of the figure follow the same bone most \
         as with its own weights; {:.1} % of the weight of a vertex lies on other bones on average.",
        weights.influences,
        weights.descent,
        100.0 * weights.same_strongest,
        weights.vertices,
        100.0 * weights.mean_difference,
    ));
}

/// A leg from its ends to its angles, and back.
fn leg_both_ways(page: &mut Page, leg: &LegBothWays) {
    page.subheading_from("The leg, solved both ways", "Cui, §2.3.3, eqs. 29–32");
    page.paragraph(
        "Backwards, from hip and ankle to the angles: the knee is where the spheres about hip and \
         ankle meet the plane of the leg. Forwards, from the angles to the ankle: the motor of the \
         calf is that of the thigh times the rotation about the knee.",
    );
    page.formula("bone = P₀ ∧ P₁ ∧ e∞, |P₀ P₁| = √(−2 P₀ · P₁)");
    page.formula("G_calf = G_thigh T(k) R T(−k)");
    let [z, y, x, knee] = leg.angles_degrees.map(|angle| format!("{angle:.2}°"));
    page.table(
        ["left leg of the still", ""],
        [
            ("thigh", format!("{:.1} mm", 1e3 * leg.thigh_metres)),
            ("calf", format!("{:.1} mm", 1e3 * leg.calf_metres)),
            (
                "hip to ankle",
                format!("{:.1} mm", 1e3 * leg.hip_to_ankle_metres),
            ),
            ("angles at the hip about z, y, x", format!("{z}, {y}, {x}")),
            ("angle at the knee", knee),
            (
                "forward again: ankle off by",
                format!("{:.1e} m", leg.ankle_error_metres),
            ),
            (
                "forward again: knee off by",
                format!("{:.4} mm", leg.knee_error_millimetres),
            ),
        ]
        .map(|(name, value)| [name.to_owned(), value]),
    );
}
