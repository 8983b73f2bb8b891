//! Tables that are written are read as they were, whatever separates their cells.

use ga_files::table::{Cell, Separator, Table, row};
use proptest::collection::vec;
use proptest::prelude::*;

const SEPARATORS: [Separator; 3] = [Separator::Comma, Separator::Semicolon, Separator::Tab];

/// A text that means neither a number nor a missing cell.
fn text() -> impl Strategy<Value = String> {
    "[a-z][a-z ,;\t\"\n#é]{0,6}[a-z]".prop_filter("not missing", |text| {
        !["na", "null"].contains(&text.as_str())
    })
}

fn number() -> impl Strategy<Value = Option<f64>> {
    prop_oneof![
        Just(None),
        any::<f64>()
            .prop_filter("finite", |x| x.is_finite())
            .prop_map(Some)
    ]
}

proptest! {
    #[test]
    fn a_table_reads_the_same_with_every_separator(
        names in [text(), text()],
        rows in vec((text(), number()), 1..6),
    ) {
        for separator in SEPARATORS {
            let mut written = row(names.clone().map(Cell::Text), separator);
            for (text, number) in &rows {
                written += &row([Cell::Text(text.clone()), Cell::from(*number)], separator);
            }
            let table = Table::with_names(written.as_bytes()).unwrap();
            prop_assert_eq!(table.names(), &names);
            prop_assert_eq!(table.len(), rows.len());
            for (index, (text, number)) in rows.iter().enumerate() {
                prop_assert_eq!(table.text(index, 0), text);
                prop_assert_eq!(table.number(index, 1).unwrap(), *number);
            }
        }
    }
}
