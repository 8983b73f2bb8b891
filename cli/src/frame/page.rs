//! Pages of reports.

use anyhow::Result;

use super::command::Report;
use super::verdict::Verdict;
use super::warning::Warning;
use ga_draw::document::Page;

/// The page of a report with what is said of files, of which the report does not know, at its top.
pub(super) fn with_warnings(mut page: Page, of_files: &[Warning]) -> Page {
    for warning in of_files {
        page.warning_first(&warning.line_of_text());
    }
    page
}

/// The page of a report that has none of its own: verdict, warnings, text, and a table
/// of the values that the text may round.
pub(super) fn of(
    report: &impl Report,
    verdict: Option<Verdict>,
    warnings: &[Warning],
    title: &str,
) -> Result<Page> {
    let mut page = Page::new(title);
    judge(&mut page, verdict, warnings);
    page.code(report.text().trim_end());
    page.values(&serde_json::to_value(report)?);
    Ok(page)
}

/// Adds the verdict and the warnings in words.
pub(crate) fn judge(page: &mut Page, verdict: Option<Verdict>, warnings: &[Warning]) {
    if let Some(verdict) = verdict {
        let text = format!("The result is {}.", verdict.word());
        match verdict {
            Verdict::Good => page.paragraph(&text),
            Verdict::Doubtful | Verdict::Failed => page.warning(&text),
        }
    }
    for warning in warnings {
        let text = warning.line_of_text();
        match warning.is_note {
            true => page.note(&text),
            false => page.warning(&text),
        }
    }
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::*;

    #[test]
    fn notes_do_not_look_like_warnings() {
        let mut page = Page::new("title");
        let note = Warning::new("exchanged_sides", "this is put right").into_note();
        let all = [Warning::new("bad_view", "look at it"), note];
        judge(&mut page, Some(Verdict::Doubtful), &all);
        let html = page.into_html();
        assert!(html.contains("<p class=\"warning\">look at it</p>"));
        assert!(html.contains("<p class=\"note\">this is put right</p>"));
        assert_eq!(html.matches("class=\"warning\"").count(), 2);
    }

    #[test]
    fn what_is_said_of_files_is_at_the_top_of_a_page_of_its_own() {
        let mut page = Page::new("title");
        page.heading("part");
        let first = Warning::new("unclear_unit", "no unit <m>").in_file(Path::new("rig.toml"));
        let html = with_warnings(page, &[first, Warning::new("omission", "names")]).into_html();
        let places = [
            "<h1>title</h1>",
            "rig.toml: no unit &lt;m&gt;",
            "names",
            "part",
        ];
        let places = places.map(|part| html.find(part).unwrap());
        assert!(places.is_sorted(), "{places:?}");
        assert_eq!(html.matches("class=\"warning\"").count(), 2);
    }
}
