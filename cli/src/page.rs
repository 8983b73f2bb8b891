//! Reports as pages of HTML that need no other file.

use std::fmt::Write;

use base64::Engine;
use base64::prelude::BASE64_STANDARD;

const STYLE: &str = "body{font:15px/1.5 system-ui,sans-serif;max-width:1040px;margin:2em auto;\
    padding:0 1em;color:#2c3440;background:#fafafc}table{border-collapse:collapse}\
    td,th{padding:.2em .9em;text-align:right;border-bottom:1px solid #dde;white-space:nowrap}\
    td:first-child,th:first-child{text-align:left;white-space:normal}\
    h1{overflow-wrap:anywhere}.wide{overflow-x:auto}\
    .warning{background:#fdf0d5;border-left:4px solid #d55e00;padding:.5em 1em}\
    svg,img{max-width:100%;height:auto}";

/// A page to which parts are added from the top to the bottom. Text may have any characters.
pub(crate) struct Page {
    html: String,
}

impl Page {
    /// A page with its heading.
    pub(crate) fn new(title: &str) -> Self {
        let title = escaped(title);
        Self {
            html: format!(
                "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\
                 <meta name=\"viewport\" content=\"width=device-width\"><title>{title}</title>\
                 <style>{STYLE}</style></head><body>\n<h1>{title}</h1>\n"
            ),
        }
    }

    pub(crate) fn paragraph(&mut self, text: &str) {
        self.add(format_args!("<p>{}</p>\n", escaped(text)));
    }

    /// A paragraph that is not overlooked.
    pub(crate) fn warning(&mut self, text: &str) {
        self.add(format_args!("<p class=\"warning\">{}</p>\n", escaped(text)));
    }

    pub(crate) fn heading(&mut self, text: &str) {
        self.add(format_args!("<h2>{}</h2>\n", escaped(text)));
    }

    /// A chart, or any other SVG picture.
    pub(crate) fn svg(&mut self, svg: &str) {
        self.add(format_args!("{}\n", svg.trim_end()));
    }

    /// A picture, with what it shows in words.
    pub(crate) fn png(&mut self, words: &str, png: &[u8]) {
        self.add(format_args!(
            "<img alt=\"{}\" src=\"data:image/png;base64,{}\">\n",
            escaped(words),
            BASE64_STANDARD.encode(png)
        ));
    }

    /// A table. The first column is aligned to the left, the others to the right.
    pub(crate) fn table<const N: usize>(
        &mut self,
        names: [&str; N],
        rows: impl IntoIterator<Item = [String; N]>,
    ) {
        self.add(format_args!("<div class=\"wide\"><table>\n"));
        self.row("th", &names);
        for row in rows {
            self.row("td", &row.each_ref().map(String::as_str));
        }
        self.add(format_args!("</table></div>\n"));
    }

    pub(crate) fn into_html(mut self) -> String {
        self.html += "</body></html>\n";
        self.html
    }

    fn row(&mut self, element: &str, fields: &[&str]) {
        self.html += "<tr>";
        for field in fields {
            self.add(format_args!("<{element}>{}</{element}>", escaped(field)));
        }
        self.html += "</tr>\n";
    }

    fn add(&mut self, html: std::fmt::Arguments<'_>) {
        // Writing to a string does not fail.
        let _ = self.html.write_fmt(html);
    }
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
        .replace('"', "&quot;")
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
