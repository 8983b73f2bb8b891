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
use super::inputs::FRAMES;
use super::paper;
use super::run::Run;
use super::scores::Scores;
use super::steps::{
    ALIGNED, COMFORT, DISPARITIES, EVALUATION, KEY_FRAMES, PEOPLE, QUALITY, TEXTURE,
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
        "A figure with dots on its skin moves in a room and is filmed by two cameras, of which \
         the right one is too bright and rolled a little; both have noise. From these films, and \
         from pictures of a chessboard whose squares are 6 cm, the commands below find the cameras, \
         the depth, the joints and the body again, as points, lines, planes, circles and motors of \
         conformal geometric algebra. They are told where the dots are on the figure at rest, about \
         where the disc on the wall is in both pictures, and where in the room the left camera \
         stands. What else the films were made of is used for the scores alone.",
    );
    score_table(&mut page, scores);
    model(&mut page, contents)?;
    page.heading("The films, and the body that was found in them");
    if let Some(people) = run.said(PEOPLE)?.page.clone() {
        page.include(people);
    }
    page.heading("Every step");
    for done in &run.steps {
        let step = done.step;
        page.subheading(&format!("{} (Cui, {})", step.title, step.section));
        page.code(step.formula);
        page.code(&done.command());
        match step.name {
            DISPARITIES => picture(&mut page, "The disparity of each pixel", "disparity.png")?,
            EVALUATION => picture(&mut page, "Found, true, and their difference", "errors.png")?,
            KEY_FRAMES => {
                picture(&mut page, "Key frames of the left film", "keys.png")?;
                curves(
                    &mut page,
                    "The curves of figure 6, of the left film.",
                    "curves.svg",
                )?;
            }
            QUALITY => curves(&mut page, "The measures over time.", "quality.svg")?,
            _ => {}
        }
        match done.said.page.clone() {
            _ if step.name == PEOPLE => page.paragraph("Its page is at the beginning of this one."),
            Some(own) => page.fold(&format!("The page of {}", words(step.line)), own),
            None => values(&mut page, &done.said.values),
        }
        match step.name {
            COMFORT => strains(&mut page, &scores.uncomfortable_before),
            ALIGNED => {
                strains(&mut page, &scores.uncomfortable_after);
                paper::comfort(&mut page)?;
            }
            TEXTURE => paper::times(&mut page),
            _ => {}
        }
    }
    algebra(&mut page, contents);
    page.heading("The tables of the paper");
    paper::tables(&mut page, run, scores)?;
    page.heading("The figures of the paper");
    picture(
        &mut page,
        "Figures 7 and 8: key frames of a stride, and three in-between frames after each",
        "sheet.png",
    )?;
    page.text_table(
        ["figure", "here"],
        paper::FIGURES.map(|row| row.map(str::to_owned)),
    );
    page.script_beside(times::FILE);
    Ok(page)
}

/// The words by which a command is called.
fn words(line: &str) -> String {
    let words = line
        .split(' ')
        .take_while(|word| !word.contains(['/', '.', '-']));
    format!("nullcone {}", words.collect::<Vec<_>>().join(" "))
}

/// The single values that a command says; lists are in `report.json`.
fn values(page: &mut Page, values: &Value) {
    let all = values.as_object().into_iter().flatten();
    let single = all.filter_map(|(name, value)| {
        let text = match value {
            Value::Number(number) => number.to_string(),
            Value::String(text) => text.clone(),
            Value::Bool(is) => is.to_string(),
            _ => return None,
        };
        Some([name.replace('_', " "), text])
    });
    page.table(["", ""], single);
}

/// The scores that something is asked of.
fn score_table(page: &mut Page, scores: &Scores) {
    let goals = scores.goals();
    if goals.iter().all(|goal| goal.is_reached) {
        page.note("All scores are within what is asked.");
    } else {
        page.warning("A score is not within what is asked.");
    }
    let rows = goals.into_iter().map(|goal| {
        let word = if goal.is_reached { "reached" } else { "missed" };
        let [name, asked, word] = [goal.name, goal.asked, word].map(str::to_owned);
        [name, goal.found, asked, word]
    });
    page.table(["score", "found", "asked", ""], rows);
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
        "The figure that was filmed, without its dots: the truth, not what was found. It is skinned by motors: x′ = G x ~G with the motor G \
         that is the weighted mean of those of the bones.",
    )?;
    Ok(())
}

fn picture(page: &mut Page, words: &str, file: &str) -> Result<()> {
    let bytes = std::fs::read(Path::new(file)).with_context(|| file.to_owned())?;
    page.paragraph(words);
    page.png(words, &bytes);
    Ok(())
}

fn curves(page: &mut Page, words: &str, file: &str) -> Result<()> {
    let svg = std::fs::read_to_string(file).with_context(|| file.to_owned())?;
    page.wide_svg(&svg, words);
    Ok(())
}

fn strains(page: &mut Page, checks: &[String]) {
    match checks {
        [] => page.note("Nothing strains the eyes: all checks are green in all frames."),
        checks => page.warning(&format!("These strain the eyes: {}.", checks.join(", "))),
    }
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
    page.subheading("Modelling points at several levels (Cui, §2.1.2, eq. 2)");
    page.code(
        "K = φ² Q (1 − C) / (S Q + t) − S, beside the depth Z = f B / (d + c_right − c_left)",
    );
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
    page.subheading("Skin weights by distance (Cui, eq. 33)");
    page.code("wᵢ = Lᵢ⁻ᵐ / Σ Lₖ⁻ᵐ over the n nearest bones");
    page.paragraph(&format!(
        "With n = {} and m = {}, {:.1} % of the {} vertices of the figure follow the same bone most \
         as with its own weights; {:.1} % of the weight of a vertex lies on other bones on average.",
        weights.influences,
        weights.descent,
        100.0 * weights.same_strongest,
        weights.vertices,
        100.0 * weights.mean_difference,
    ));
}

fn leg_both_ways(page: &mut Page, leg: &LegBothWays) {
    page.subheading("The leg, solved both ways (Cui, §2.3.3, eqs. 29–32)");
    page.code(
        "bone = P₀ ∧ P₁ ∧ e∞, |P₀ P₁| = √(−2 P₀ · P₁)\n\
         inverse: the knee is where the spheres about hip and ankle meet the plane of the leg\n\
         forward: G_calf = G_thigh (T(k) R T(−k))",
    );
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
