//! What could not be measured, in words.

use crate::comfort::{Dimension, Missing, Summary};

use super::verdict::frames;
use super::words;

/// A sentence for each reason why rows of a video have no score in some frames.
#[must_use]
pub fn notes(summary: &Summary) -> Vec<String> {
    let mut notes = Vec::new();
    if summary.undecided.frames() > 0 {
        notes.push(format!(
            "The order of the eyes could not be decided in {}: {}.",
            summary.undecided,
            Missing::Unknown.reason()
        ));
    }
    for missing in Missing::ALL.into_iter().skip(1) {
        let count = |dimension| summary.row(dimension).missing[missing as usize];
        let mut rest: Vec<Dimension> = Dimension::ALL.to_vec();
        rest.retain(|dimension| count(*dimension) > 0);
        // Rows that lack the same frames share a sentence.
        while let Some(first) = rest.first().copied() {
            let (same, others) = rest
                .into_iter()
                .partition::<Vec<_>, _>(|dimension| count(*dimension) == count(first));
            rest = others;
            let names: Vec<String> = same
                .into_iter()
                .map(|dimension| dimension.in_words().to_lowercase())
                .collect();
            notes.push(format!(
                "No score for {} {}: {}.",
                words::listed(&names),
                frames(count(first), summary.frames),
                missing.reason()
            ));
        }
    }
    notes
}
