//! The page of a report that has none of its own.

use anyhow::Result;

use super::command::Report;
use super::verdict::Verdict;
use super::warning::Warning;
use ga_draw::document::Page;

/// A page with verdict, warnings, text, and a table of the values that the text may round.
pub(super) fn of(
    report: &impl Report,
    verdict: Option<Verdict>,
    warnings: &[Warning],
    title: &str,
) -> Result<Page> {
    let mut page = Page::new(title);
    if let Some(verdict) = verdict {
        let text = format!("The result is {}.", verdict.word());
        match verdict {
            Verdict::Good => page.paragraph(&text),
            Verdict::Doubtful | Verdict::Failed => page.warning(&text),
        }
    }
    for warning in warnings {
        page.warning(&warning.line_of_text());
    }
    page.code(report.text().trim_end());
    page.values(&serde_json::to_value(report)?);
    Ok(page)
}
