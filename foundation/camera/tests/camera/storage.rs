//! Named values as OpenCV's `FileStorage` has them: round trips, and what is none.

use ga_camera::format::CameraFileError;
use ga_camera::format::storage::{Matrix, Storage};
use proptest::prelude::*;

proptest! {
    #[test]
    fn numbers_and_texts_come_back(
        numbers in prop::collection::vec(prop::num::f64::NORMAL | prop::num::f64::ZERO, 1..20),
        text in "\\PC{0,20}",
    ) {
        let mut storage = Storage::default();
        storage.set_matrix("m", Matrix::new(1, numbers.len(), numbers.clone()).unwrap());
        storage.set_number("n", numbers[0]);
        storage.set_text("t", &text);
        let encoded = storage.encode();
        let again = Storage::decode(encoded.as_bytes()).unwrap();
        let matrix = again.matrix("m").unwrap().unwrap();
        prop_assert_eq!(matrix.values(), numbers.as_slice());
        prop_assert_eq!(again.number("n").unwrap(), Some(numbers[0]));
        prop_assert_eq!(again.text("t").unwrap(), Some(text));
        // What was read is written as it was read.
        let third = Storage::decode(again.encode().as_bytes()).unwrap();
        prop_assert_eq!(third.matrix("m").unwrap(), again.matrix("m").unwrap());
    }
}

#[test]
fn no_values_and_values_with_any_name_come_back() {
    let empty = Storage::default().encode();
    assert_eq!(
        Storage::decode(empty.as_bytes()).unwrap(),
        Storage::default()
    );
    // YAML allows 1024 characters before the colon, unless the name is marked.
    let [long, escaped] = ["n".repeat(1500), "\u{5}".repeat(300)];
    for name in [
        "- a", "a: b", ")M1", "#", "---", "\"", "a b", "1", &long, &escaped,
    ] {
        let mut storage = Storage::default();
        storage.set_number(name, 1.5);
        let back = Storage::decode(storage.encode().as_bytes()).unwrap();
        let again = Storage::decode(back.encode().as_bytes()).unwrap();
        for read in [back, again] {
            assert_eq!(read.number(name).unwrap(), Some(1.5), "{name:?}");
        }
    }
}

#[test]
fn what_is_not_such_yaml() {
    let error = |bytes: &[u8]| Storage::decode(bytes).unwrap_err();
    assert!(matches!(
        error(b"a: 1\nb: \xff"),
        CameraFileError::NotText { line: 2 }
    ));
    assert!(matches!(
        error(b"<?xml version=\"1.0\"?>"),
        CameraFileError::Syntax { format: "XML", .. }
    ));
    assert!(matches!(
        error(b"just words"),
        CameraFileError::Unsupported { line: 1, .. }
    ));
    assert!(matches!(error(b""), CameraFileError::Unsupported { .. }));
    assert!(matches!(
        error(b"%YAML:1.0\na: [ 1, 2\nb: 3"),
        CameraFileError::Syntax { line: 2.., .. }
    ));
    assert!(matches!(
        error(b"a: &x [1, *x]\n"),
        CameraFileError::Unsupported { line: 1, .. } | CameraFileError::Syntax { line: 1, .. }
    ));
    assert!(matches!(
        error(b"a: 1\nb: *x\n"),
        CameraFileError::Syntax { line: 2, .. }
    ));
    assert!(matches!(
        error(b"a: 1\nb:\n  <<: 2\n"),
        CameraFileError::Unsupported { line: 3, .. }
    ));
    // Ten references to ten references and so on are ten thousand million values.
    let mut laughs = "a0: &a0 [1, 1]\n".to_owned();
    for k in 1..=10 {
        let references = vec![format!("*a{}", k - 1); 10].join(", ");
        laughs += &format!("a{k}: &a{k} [{references}]\n");
    }
    assert!(matches!(
        error(laughs.as_bytes()),
        CameraFileError::Unsupported { line: 6..=7, .. }
    ));
    // References into references nest as deeply as lists may: 15 in the map of the file.
    let mut nested = "a0: &a0 [1]\n".to_owned();
    for k in 1..=20 {
        nested += &format!("a{k}: &a{k} [*a{}]\n", k - 1);
    }
    assert!(matches!(
        error(nested.as_bytes()),
        CameraFileError::Unsupported { line: 16, .. }
    ));
    assert!(matches!(
        error(b"a: 1\n---\na: 2\n"),
        CameraFileError::Unsupported { line: 3, .. }
    ));
    let lists = |depth: usize| format!("a: {}{}", "[".repeat(depth), "]".repeat(depth));
    assert!(Storage::decode(lists(15).as_bytes()).is_ok());
    assert!(matches!(
        error(lists(16).as_bytes()),
        CameraFileError::Unsupported { line: 1, .. }
    ));
    assert!(matches!(
        error(lists(100_000).as_bytes()),
        CameraFileError::Unsupported { .. } | CameraFileError::Syntax { .. }
    ));
    // Sizes that would overflow are compared with the values before anything is allocated.
    let huge = "a: { rows: 4294967295, cols: 4294967295, dt: \"4294967295d\", data: [ 1 ] }";
    let storage = Storage::decode(huge.as_bytes()).unwrap();
    assert!(matches!(
        storage.matrix("a"),
        Err(CameraFileError::ValueCount { found: 1, .. })
    ));
    assert!(matches!(
        Storage::decode(b"a: x").unwrap().number("a"),
        Err(CameraFileError::Value { place, .. }) if place.line == Some(1)
    ));
}
