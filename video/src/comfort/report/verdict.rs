//! What to make of the rows: what is good, and what to mend first.

use crate::comfort::stereoscopy::Stereoscopy;
use crate::comfort::{Dimension, RowSummary, Summary, Viewing};

use super::causes::{Cause, Heights, cause_of, causes};
use super::moments::{Moment, Moments};
use super::words;

/// A row that is orange or red in some frames.
pub(super) struct Problem<'a> {
    pub(super) dimension: Dimension,
    pub(super) row: &'a RowSummary,
    /// The worst frames, from the worst one; there is one at least.
    pub(super) moments: &'a [Moment],
    /// Whether other rows may follow from it, and what it may follow from itself.
    is_cause: bool,
    pub(super) cause: Option<Cause>,
}

/// The rows with problems, from the one to be mended first.
pub(super) fn problems<'a>(
    summary: &'a Summary,
    moments: &'a Moments,
    heights: &Heights,
    viewing: &Viewing,
) -> Vec<Problem<'a>> {
    let causes = causes(summary, heights, viewing);
    let all = Dimension::ALL.into_iter().filter_map(|dimension| {
        let moments = moments.row(dimension);
        let worst = &moments.first()?.record;
        Some(Problem {
            dimension,
            row: summary.row(dimension),
            moments,
            is_cause: causes.iter().any(|cause| cause.dimension() == dimension),
            cause: cause_of(worst, dimension, (summary, heights), viewing),
        })
    });
    let mut problems: Vec<Problem> = all.collect();
    // The sort is stable: equal ones stay in the order of the table.
    problems.sort_by(|a, b| {
        let by_weight = || b.weight().total_cmp(&a.weight());
        a.rank().cmp(&b.rank()).then_with(by_weight)
    });
    problems
}

impl Problem<'_> {
    /// The worst frame.
    pub(super) fn worst(&self) -> &Moment {
        &self.moments[0]
    }

    /// Orange and red frames.
    pub(super) fn frames(&self) -> usize {
        self.row.levels[1] + self.row.levels[2]
    }

    pub(super) fn is_red(&self) -> bool {
        self.row.levels[2] > 0
    }

    /// The order of the eyes comes first, since depth means nothing without it, then what other
    /// rows may follow from, and these after the rest; weak depth comes last, since it does not
    /// strain the eyes.
    fn rank(&self) -> usize {
        match self.dimension {
            Dimension::Stereoscopy => 0,
            Dimension::WeakDepth => 4,
            _ if self.is_cause => 1,
            _ if self.cause.is_some() => 3,
            _ => 2,
        }
    }

    /// How much it matters among those of its rank: red frames count twice.
    fn weight(&self) -> f64 {
        let [_, orange, red] = self.row.levels.map(|count| count as f64);
        orange + 2.0 * red
    }

    /// What it may follow from, in a sentence that begins with a space.
    pub(super) fn explanation(&self) -> String {
        self.cause.map_or_else(String::new, |cause| {
            format!(
                " It may follow from {}: measure it again when that is removed.",
                cause.name()
            )
        })
    }
}

/// Two or three sentences; `place` states a frame and its time.
pub(super) fn sentences(
    summary: &Summary,
    problems: &[Problem<'_>],
    viewing: &Viewing,
    place: impl Fn(usize) -> String,
) -> Vec<String> {
    let (mut good, mut missing) = (Vec::new(), Vec::new());
    for dimension in Dimension::ALL {
        let row = summary.row(dimension);
        if row.scored == 0 {
            missing.push(dimension.in_words().to_lowercase());
        } else if row.levels[0] == row.scored {
            good.push(words::merit(dimension).to_owned());
        }
    }
    let mut sentences = Vec::new();
    // Too little depth does not strain the eyes.
    let strains = |problem: &&Problem| problem.dimension != Dimension::WeakDepth;
    let straining = problems.iter().filter(strains).count();
    let red = problems.iter().filter(strains);
    let red = red.filter(|problem| problem.is_red()).count();
    sentences.push(match (straining, red) {
        (0, _) if problems.is_empty() && good.is_empty() => {
            "Nothing could be measured in this video.".into()
        }
        (0, _) if problems.is_empty() => {
            "This video is comfortable: every check that could be made is green in all frames."
                .into()
        }
        (0, _) => "This video is comfortable, but a part of it is flat.".into(),
        (count, red) => {
            let strain = match count {
                1 => "one of eleven checks strains the eyes",
                _ => &format!("{} of eleven checks strain the eyes", number(count)),
            };
            let (nearly, severe) = match red {
                0 => ("nearly", "none is severe".into()),
                1 if count == 1 => ("not", "is severe".into()),
                red if red == count => ("not", "all of them are severe".into()),
                1 => ("not", "one of them is severe".into()),
                red => ("not", format!("{} of them are severe", number(red))),
            };
            format!("This video is {nearly} comfortable: {strain} in some frames, and {severe}.")
        }
    });
    if let Some(first) = problems.first() {
        let record = &first.worst().record;
        let mut text = format!(
            "Mend first: {}, {}. At its worst, {}, {}.",
            words::trouble(record, first.dimension, viewing).to_lowercase(),
            frames(first.frames(), summary.frames),
            place(record.frame),
            words::finding(record, first.dimension, viewing)
        );
        if record.stereoscopy == Stereoscopy::Exchanged
            && first.dimension == Dimension::Stereoscopy
            && problems.len() > 1
        {
            text += " Measure again after that, since exchanged views turn depth around.";
        }
        sentences.push(text);
    }
    let mut text = String::new();
    if !good.is_empty() && !problems.is_empty() {
        text = format!("Good in all frames: {}. ", words::listed(&good));
    }
    if !missing.is_empty() && missing.len() < Dimension::ALL.len() {
        text += &format!("Not to be measured here: {}.", words::listed(&missing));
    }
    if !text.is_empty() {
        sentences.push(text.trim_end().into());
    }
    sentences
}

/// "in 3 of 48 frames".
pub(super) fn frames(count: usize, all: usize) -> String {
    match count == all {
        true => format!("in all {all} frames"),
        false => format!("in {count} of {all} frames"),
    }
}

fn number(count: usize) -> &'static str {
    const NAMES: [&str; 12] = [
        "none", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten",
        "all",
    ];
    NAMES[count.min(11)]
}
