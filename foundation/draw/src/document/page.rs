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
    .wide td:first-child,.wide th:first-child{position:sticky;left:0;background:#fafafc}\
    @media(max-width:600px){td,th{padding:.2em .5em}}\
    h1{overflow-wrap:anywhere}.wide{overflow-x:auto}\
    .warning{background:#fdf0d5;border-left:4px solid #d55e00;padding:.5em 1em}\
    .note{background:#e6f0f8;border-left:4px solid #0072b2;padding:.5em 1em}\
    svg,img{max-width:100%;height:auto}.wide svg{max-width:none}\
    .pictures{display:flex;flex-wrap:wrap;gap:1em}\
    .pictures figure{flex:1 1 440px;min-width:0;margin:0}\
    figure{margin:1.2em 0 2em}figcaption{font-size:.95em;margin-top:.3em}\
    pre{background:#eef0f4;padding:.6em 1em;overflow-x:auto}\
    p code,td code,li code{background:#eef0f4;padding:0 .25em}\
    .formula{font-family:Cambria Math,STIX Two Math,Latin Modern Math,DejaVu Serif,serif;\
    margin:.8em 1.5em;font-size:1.07em}h3 small{font-weight:normal;color:#6a727c;font-size:.8em}\
    nav ul{columns:2 220px;padding-left:1.2em}nav li{break-inside:avoid}\
    .files{font-size:.93em}\
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
    /// The headings with the numbers of their levels.
    headings: Vec<(u8, String)>,
}

/// Where the list of headings goes.
const CONTENTS: &str = "<!-- contents -->\n";

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
            headings: vec![],
        }
    }

    /// A list of the headings of the page, which lead to their parts; those of
    /// [included](Self::include) pages are not in it.
    pub fn contents(&mut self) {
        self.html += CONTENTS;
    }

    /// A heading below those of [`heading`](Self::heading).
    pub fn subheading(&mut self, text: &str) {
        self.add_heading(3, text, "");
    }

    /// A [`subheading`](Self::subheading) with where it is from, in smaller letters.
    pub fn subheading_from(&mut self, text: &str, source: &str) {
        self.add_heading(3, text, &format!(" <small>{}</small>", escaped(source)));
    }

    fn add_heading(&mut self, level: u8, text: &str, rest: &str) {
        self.headings.push((level, text.to_owned()));
        let (number, text) = (self.headings.len(), escaped(text));
        self.add(format_args!(
            "<h{level} id=\"part-{number}\">{text}{rest}</h{level}>\n"
        ));
    }

    /// A paragraph. What stands between two backticks is code.
    pub fn paragraph(&mut self, text: &str) {
        self.add(format_args!("<p>{}</p>\n", marked(text)));
    }

    /// A formula in a line of its own. Letters after `_` are an index: in `G_root x`, `root`.
    pub fn formula(&mut self, text: &str) {
        let mut parts = text.split('_').map(escaped);
        let mut html = parts.next().unwrap_or_default();
        for part in parts {
            let end = part.find(|c: char| !c.is_alphanumeric());
            let (index, rest) = part.split_at(end.unwrap_or(part.len()));
            html += &format!("<sub>{index}</sub>{rest}");
        }
        self.add(format_args!("<p class=\"formula\">{html}</p>\n"));
    }

    /// Links to files beside the page.
    pub fn files<'a>(&mut self, paths: impl IntoIterator<Item = &'a str>) {
        let links = paths.into_iter().map(|path| {
            let path = escaped(path);
            format!("<a href=\"{path}\">{path}</a>")
        });
        let links: Vec<String> = links.collect();
        let links = links.join(", ");
        self.add(format_args!("<p class=\"files\">Files: {links}</p>\n"));
    }

    /// A paragraph that is not overlooked.
    pub fn warning(&mut self, text: &str) {
        self.add(format_args!("{}", warning(text)));
    }

    /// A paragraph with something that was done, or that the reader should know, and that is not
    /// wrong.
    pub fn note(&mut self, text: &str) {
        self.add(format_args!("<p class=\"note\">{}</p>\n", marked(text)));
    }

    /// The same below the heading of the page, before the parts that it has.
    pub fn warning_first(&mut self, text: &str) {
        let warning = warning(text);
        self.html.insert_str(self.begin, &warning);
        self.begin += warning.len();
    }

    /// A heading of a part.
    pub fn heading(&mut self, text: &str) {
        self.add_heading(2, text, "");
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
                self.add(format_args!("<td{class}>{}</td>", marked(&text)));
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

    /// The parts of another page, without its heading; those of its parts are a level lower.
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
        for level in [4, 3, 2] {
            parts = lowered(&parts, level);
        }
        self.html += &parts;
    }

    /// The whole page.
    #[must_use]
    pub fn into_html(mut self) -> String {
        if self.html.contains(CONTENTS) {
            self.html = self.html.replacen(CONTENTS, &self.list_of_headings(), 1);
        }
        self.html += "</body></html>\n";
        self.html
    }

    fn list_of_headings(&self) -> String {
        let mut list = "<nav><ul>\n".to_owned();
        for (index, (level, text)) in self.headings.iter().enumerate() {
            let (number, text) = (index + 1, escaped(text));
            let link = format!("<a href=\"#part-{number}\">{text}</a>");
            list += &match level {
                2 => format!("<li><b>{link}</b></li>\n"),
                _ => format!("<li>{link}</li>\n"),
            };
        }
        list + "</ul></nav>\n"
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

/// Headings of a level as those of the next, without the names by which lists of headings lead to
/// them.
fn lowered(html: &str, level: u8) -> String {
    let (begin, end) = (format!("<h{level}"), format!("</h{level}>"));
    let mut parts = html.split(&begin);
    let mut lowered = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        let rest = part.find('>').map_or(part, |place| &part[place..]);
        lowered += &format!("<h{}{rest}", level + 1);
    }
    lowered.replace(&end, &format!("</h{}>", level + 1))
}

fn warning(text: &str) -> String {
    format!("<p class=\"warning\">{}</p>\n", marked(text))
}

/// Text of which what stands between two backticks is code.
fn marked(text: &str) -> String {
    let text = escaped(text);
    let parts: Vec<&str> = text.split('`').collect();
    // An odd number of backticks would leave code without an end.
    if parts.len().is_multiple_of(2) {
        return text;
    }
    let parts = parts.iter().enumerate();
    let parts = parts.map(|(number, part)| match number % 2 {
        0 => (*part).to_owned(),
        _ => format!("<code>{part}</code>"),
    });
    parts.collect()
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

    #[test]
    fn contents_lead_to_the_headings_of_the_page_alone() {
        let mut other = Page::new("Other");
        other.heading("Far");
        other.subheading("Farther");
        let mut page = Page::new("Page");
        page.contents();
        page.heading("Near <1>");
        page.include(other);
        page.subheading_from("Last", "§2");
        let html = page.into_html();
        let list = html
            .split("<nav>")
            .nth(1)
            .and_then(|rest| rest.split("</nav>").next());
        let list = list.unwrap_or_default();
        assert_eq!(list.matches("<li>").count(), 2);
        assert!(list.contains("<a href=\"#part-1\">Near &lt;1&gt;</a>"));
        assert!(list.contains("<a href=\"#part-2\">Last</a>"));
        assert_eq!(html.matches("id=\"part-2\"").count(), 1);
        assert!(html.contains("<h3 id=\"part-2\">Last <small>§2</small></h3>"));
        assert!(html.contains(">Far</h3>") && html.contains(">Farther</h4>"));
    }

    #[test]
    fn indices_and_code_are_marked() {
        let mut page = Page::new("Page");
        page.formula("Z = f B / (d + c_right − c_left) < 1");
        page.paragraph("`a < b` and ` alone");
        page.paragraph("`a < b` is code");
        let html = page.into_html();
        let formula = "Z = f B / (d + c<sub>right</sub> − c<sub>left</sub>) &lt; 1";
        assert!(html.contains(formula));
        assert!(html.contains("<p>`a &lt; b` and ` alone</p>"));
        assert!(html.contains("<p><code>a &lt; b</code> is code</p>"));
    }
}
