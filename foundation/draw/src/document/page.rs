//! Reports as pages of HTML that need no other file.

use std::fmt::Write;

use base64::Engine;
use base64::prelude::BASE64_STANDARD;

use crate::escape::escaped;

const STYLE: &str = "body{font:15px/1.5 system-ui,sans-serif;max-width:1040px;margin:2em auto;\
    padding:0 1em;color:#2c3440;background:#fafafc}table{border-collapse:collapse}\
    td,th{padding:.2em .9em;text-align:right;border-bottom:1px solid #dde;white-space:nowrap}\
    td:first-child,th:first-child{text-align:left;white-space:normal}\
    .narrow td,.narrow th{padding:.2em .5em}.narrow th{white-space:normal;vertical-align:bottom}\
    .narrow td:first-child{white-space:nowrap}\
    h1{overflow-wrap:anywhere}.wide{overflow-x:auto}\
    .warning{background:#fdf0d5;border-left:4px solid #d55e00;padding:.5em 1em}\
    .note{background:#e6f0f8;border-left:4px solid #0072b2;padding:.5em 1em}\
    svg,img{max-width:100%;height:auto}.wide svg{max-width:none}\
    .pictures{display:flex;flex-wrap:wrap;gap:1em}\
    .pictures figure{flex:1 1 440px;min-width:0;margin:0}\
    figure{margin:1.2em 0 2em}figcaption{font-size:.95em;margin-top:.3em}\
    pre{background:#eef0f4;padding:.6em 1em;white-space:pre-wrap;overflow-wrap:anywhere}\
    .green{background:#d3efe3}.orange{background:#ffd27a}.red{background:#a3261b;color:#fff}\
    .text td,.text th{text-align:left;white-space:normal;vertical-align:top}\
    .none{background:#ececf0;color:#555}\
    details{border-left:2px solid #dde;padding-left:1em;margin:1em 0}\
    summary{cursor:pointer;color:#0072b2}";

/// A page to which parts are added from the top to the bottom. Text may have any characters.
#[derive(Clone, Debug)]
pub struct Page {
    html: String,
    /// The length of what stands before the first part.
    begin: usize,
    /// The style sheets that were added.
    styles: Vec<&'static str>,
    /// The scripts that were added.
    scripts: Vec<&'static str>,
}

impl Page {
    /// A page with its heading.
    #[must_use]
    pub fn new(title: &str) -> Self {
        let title = escaped(title);
        let html = format!(
            "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\
             <meta name=\"viewport\" content=\"width=device-width\"><title>{title}</title>\
             <style>{STYLE}</style></head><body>\n<h1>{title}</h1>\n"
        );
        let begin = html.len();
        Self {
            html,
            begin,
            styles: vec![],
            scripts: vec![],
        }
    }

    /// A heading below those of [`heading`](Self::heading).
    pub fn subheading(&mut self, text: &str) {
        self.add(format_args!("<h3>{}</h3>\n", escaped(text)));
    }

    /// A paragraph.
    pub fn paragraph(&mut self, text: &str) {
        self.add(format_args!("<p>{}</p>\n", escaped(text)));
    }

    /// A paragraph that is not overlooked.
    pub fn warning(&mut self, text: &str) {
        self.add(format_args!("{}", warning(text)));
    }

    /// A paragraph with something that was done, or that the reader should know, and that is not
    /// wrong.
    pub fn note(&mut self, text: &str) {
        self.add(format_args!("<p class=\"note\">{}</p>\n", escaped(text)));
    }

    /// The same below the heading of the page, before the parts that it has.
    pub fn warning_first(&mut self, text: &str) {
        let warning = warning(text);
        self.html.insert_str(self.begin, &warning);
        self.begin += warning.len();
    }

    /// A heading of a part.
    pub fn heading(&mut self, text: &str) {
        self.add(format_args!("<h2>{}</h2>\n", escaped(text)));
    }

    /// A chart, or any other SVG picture. It keeps its size, so that what is written in it is
    /// legible; in narrow windows it can be moved to the side.
    pub fn svg(&mut self, svg: &str) {
        self.add(format_args!(
            "<div class=\"wide\">{}</div>\n",
            svg.trim_end()
        ));
    }

    /// An [`svg`](Self::svg) with what it shows in words below it.
    pub fn wide_svg(&mut self, svg: &str, caption: &str) {
        self.add(format_args!(
            "<figure><div class=\"wide\">{}</div><figcaption>{}</figcaption></figure>\n",
            svg.trim_end(),
            escaped(caption)
        ));
    }

    /// Text for a terminal.
    pub fn code(&mut self, text: &str) {
        let lines: Vec<String> = text.lines().map(escaped).collect();
        let text = lines.join("\n");
        self.add(format_args!("<pre><code>{text}</code></pre>\n"));
    }

    /// Paragraphs with numbers from 1; each begins with a few important words.
    pub fn numbered(&mut self, items: impl IntoIterator<Item = (String, String)>) {
        self.html += "<ol>\n";
        for (start, text) in items {
            self.add(format_args!(
                "<li><b>{}</b> {}</li>\n",
                escaped(&start),
                escaped(&text)
            ));
        }
        self.html += "</ol>\n";
    }

    /// A picture, with what it shows in words.
    pub fn png(&mut self, words: &str, png: &[u8]) {
        self.add(format_args!(
            "<img alt=\"{}\" src=\"data:image/png;base64,{}\">\n",
            escaped(words),
            BASE64_STANDARD.encode(png)
        ));
    }

    /// Pictures beside each other where there is room, with what each shows in words below it.
    pub fn pictures<'a>(&mut self, pictures: impl IntoIterator<Item = (&'a str, &'a [u8])>) {
        self.html += "<div class=\"pictures\">\n";
        for (words, png) in pictures {
            self.html += "<figure>";
            self.png(words, png);
            self.add(format_args!(
                "<figcaption>{}</figcaption></figure>\n",
                escaped(words)
            ));
        }
        self.html += "</div>\n";
    }

    /// A table. The first column is aligned to the left, the others to the right.
    pub fn table<const N: usize>(
        &mut self,
        names: [&str; N],
        rows: impl IntoIterator<Item = [String; N]>,
    ) {
        self.add_table(
            "wide",
            names,
            rows.into_iter().map(|row| row.map(Cell::from)),
        );
    }

    /// A table of two columns, of which [a script beside the page](Self::script_beside) may fill in
    /// the second: its cells have these keys as `data-time`, and say `missing` before.
    pub fn table_to_fill<'a>(
        &mut self,
        names: [&str; 2],
        rows: impl IntoIterator<Item = (&'a str, &'a str)>,
        missing: &str,
    ) {
        let [first, second] = names.map(escaped);
        self.add(format_args!(
            "<div class=\"wide\"><table>\n<tr><th>{first}</th><th>{second}</th></tr>\n"
        ));
        let missing = escaped(missing);
        for (text, key) in rows {
            let [text, key] = [text, key].map(escaped);
            self.add(format_args!(
                "<tr><td>{text}</td><td data-time=\"{key}\">{missing}</td></tr>\n"
            ));
        }
        self.html += "</table></div>\n";
    }

    /// A [`table`](Self::table) with many columns, whose cells may have colours.
    pub fn tinted_table<const N: usize>(
        &mut self,
        names: [&str; N],
        rows: impl IntoIterator<Item = [Cell; N]>,
    ) {
        self.add_table("wide narrow", names, rows);
    }

    fn add_table<const N: usize>(
        &mut self,
        class: &str,
        names: [&str; N],
        rows: impl IntoIterator<Item = [Cell; N]>,
    ) {
        self.add(format_args!("<div class=\"{class}\"><table>\n<tr>"));
        for name in names {
            self.add(format_args!("<th>{}</th>", escaped(name)));
        }
        self.html += "</tr>\n";
        for row in rows {
            self.html += "<tr>";
            for Cell { text, tint } in row {
                let class = match tint {
                    Some(Tint::Green) => " class=\"green\"",
                    Some(Tint::Orange) => " class=\"orange\"",
                    Some(Tint::Red) => " class=\"red\"",
                    Some(Tint::Grey) => " class=\"none\"",
                    None => "",
                };
                self.add(format_args!("<td{class}>{}</td>", escaped(&text)));
            }
            self.html += "</tr>\n";
        }
        self.html += "</table></div>\n";
    }

    /// A table of sentences, which are aligned to the left and may take several lines.
    pub fn text_table<const N: usize>(
        &mut self,
        names: [&str; N],
        rows: impl IntoIterator<Item = [String; N]>,
    ) {
        let rows = rows.into_iter().map(|row| row.map(Cell::from));
        self.add_table("wide text", names, rows);
    }

    /// A script of a file beside the page, which need not be there.
    pub fn script_beside(&mut self, file: &str) {
        self.add(format_args!(
            "<script src=\"{}\"></script>\n",
            escaped(file)
        ));
    }

    /// The parts of another page, below a line that unfolds them.
    pub fn fold(&mut self, summary: &str, other: Self) {
        self.add(format_args!(
            "<details><summary>{}</summary>\n",
            escaped(summary)
        ));
        self.include(other);
        self.add(format_args!("</details>\n"));
    }

    /// The parts of another page, without its heading.
    pub fn include(&mut self, other: Self) {
        for style in other.styles {
            self.add_style(style);
        }
        let heading = other.html.find("</h1>\n").map_or(0, |place| place + 6);
        let mut parts = other.html[heading..].to_owned();
        for script in other.scripts {
            if self.scripts.contains(&script) {
                parts = parts.replace(script, "");
            } else {
                self.scripts.push(script);
            }
        }
        self.html += &parts;
    }

    /// The whole page.
    #[must_use]
    pub fn into_html(mut self) -> String {
        self.html += "</body></html>\n";
        self.html
    }

    /// Adds a style sheet for a kind of part, unless the page has it.
    pub(super) fn add_style(&mut self, style: &'static str) {
        if self.styles.contains(&style) {
            return;
        }
        self.styles.push(style);
        let end = self.html.find("</style>").unwrap_or_default();
        self.html.insert_str(end, style);
        self.begin += style.len();
    }

    /// Adds those scripts for a kind of part that the page does not have: kinds share scripts, and
    /// none may be declared twice.
    pub(super) fn add_scripts(&mut self, scripts: &[&'static str]) {
        let mut missing = String::new();
        for script in scripts {
            if !self.scripts.contains(script) {
                self.scripts.push(script);
                missing += script;
            }
        }
        if !missing.is_empty() {
            self.add(format_args!("<script>\n{missing}</script>\n"));
        }
    }

    pub(super) fn add(&mut self, html: std::fmt::Arguments<'_>) {
        // Writing to a string does not fail.
        let _ = self.html.write_fmt(html);
    }
}

fn warning(text: &str) -> String {
    format!("<p class=\"warning\">{}</p>\n", escaped(text))
}

/// A part as per cent, without the digits that only rounding makes.
///
/// ```
/// assert_eq!(ga_draw::document::percent(0.57), 57.0);
/// ```
#[must_use]
pub fn percent(part: f64) -> f64 {
    (part * 1e8).round() / 1e6
}

/// A cell of a table.
#[derive(Clone, Debug)]
pub struct Cell {
    /// What it says.
    pub text: String,
    /// Its colour; `None` for that of the page.
    pub tint: Option<Tint>,
}

impl From<String> for Cell {
    fn from(text: String) -> Self {
        Self { text, tint: None }
    }
}

/// A colour of cells.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tint {
    /// Comfortable, or good.
    Green,
    /// Doubtful.
    Orange,
    /// Bad.
    Red,
    /// Without a value.
    Grey,
}

#[cfg(test)]
mod tests {
    use super::Page;

    #[test]
    fn text_stays_text() {
        let mut page = Page::new("<a> & \"b\"");
        page.paragraph("x < y");
        page.table(["n"], [["<td>".to_owned()]]);
        let html = page.into_html();
        assert!(html.contains("<h1>&lt;a&gt; &amp; &quot;b&quot;</h1>"));
        assert!(html.contains("<p>x &lt; y</p>") && html.contains("<td>&lt;td&gt;</td>"));
        assert!(html.ends_with("</body></html>\n"));
    }
}
