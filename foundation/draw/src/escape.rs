//! Texts in XML, HTML and scripts.

/// A text as it is written in XML and HTML, between tags or in an attribute. Characters that XML
/// does not allow, such as control characters, become the replacement character. The libraries for
/// escaping leave these in place, which makes the document invalid.
pub(crate) fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for letter in text.chars() {
        match letter {
            '&' => out += "&amp;",
            '<' => out += "&lt;",
            '>' => out += "&gt;",
            '"' => out += "&quot;",
            '\'' => out += "&#39;",
            '\t' | '\n' | '\r' => out.push(' '),
            '\u{0}'..='\u{1f}' | '\u{7f}'..='\u{9f}' | '\u{fffe}' | '\u{ffff}' => {
                out.push('\u{fffd}');
            }
            letter => out.push(letter),
        }
    }
    out
}

/// JSON as it is written in a script element: it cannot contain the beginning or end of a tag.
pub(crate) fn in_script(json: &str) -> String {
    json.replace('<', "\\u003c")
        .replace('>', "\\u003e")
        .replace('&', "\\u0026")
        .replace('\u{2028}', "\\u2028")
        .replace('\u{2029}', "\\u2029")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn markup_is_text() {
        assert_eq!(
            escaped("<a href=\"x\">'&'</a>\u{7}\n"),
            "&lt;a href=&quot;x&quot;&gt;&#39;&amp;&#39;&lt;/a&gt;\u{fffd} "
        );
    }

    #[test]
    fn a_script_cannot_be_ended() {
        assert_eq!(
            in_script(r#"["</script><!--&"]"#),
            r#"["\u003c/script\u003e\u003c!--\u0026"]"#
        );
    }
}
