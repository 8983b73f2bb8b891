//! Circles in small crates that are written for the purpose.

use std::fs;
use std::path::Path;

use nullcone_circles::{Circle, circles};

/// The circles of a crate of these files, each with its path from `src` and its text.
fn circles_of(files: &[(&str, &str)]) -> Vec<Circle> {
    let folder = tempfile::tempdir().expect("there is a temporary folder");
    for (path, text) in files {
        let path = folder.path().join(path);
        fs::create_dir_all(path.parent().expect("the file has a folder")).expect("it can be made");
        fs::write(path, text).expect("the file can be written");
    }
    circles(folder.path()).expect("the crate can be read")
}

/// The names by which one file of a circle uses another, with commas between them.
fn names(circle: &Circle, user: &str, used: &str) -> String {
    let pair = (Path::new(user).to_path_buf(), Path::new(used).to_path_buf());
    let names: Vec<&str> = circle.uses[&pair].iter().map(String::as_str).collect();
    names.join(", ")
}

#[test]
fn two_files_that_use_each_other_are_a_circle() {
    let found = circles_of(&[
        ("lib.rs", "mod a; mod b; mod c;"),
        (
            "a.rs",
            "use crate::b::Half; pub struct Whole(Half); pub fn whole() {}",
        ),
        (
            "b.rs",
            "pub struct Half; pub fn more() { super::a::whole() }",
        ),
        ("c.rs", "use super::a::Whole; fn c(_: Whole) {}"),
    ]);
    assert_eq!(found.len(), 1);
    assert_eq!(found[0].uses.len(), 2);
    assert_eq!(names(&found[0], "a.rs", "b.rs"), "Half");
    assert_eq!(names(&found[0], "b.rs", "a.rs"), "whole");
}

#[test]
fn a_circle_through_several_files_is_found() {
    let found = circles_of(&[
        ("lib.rs", "mod a; mod b; mod c;"),
        ("a.rs", "pub fn a() { crate::b::b() }"),
        ("b.rs", "pub fn b() { crate::c::c() }"),
        ("c.rs", "pub fn c() { crate::a::a() }"),
    ]);
    assert_eq!(found.len(), 1);
    assert_eq!(found[0].uses.len(), 3);
}

#[test]
fn a_parent_and_a_child_that_use_each_other_are_a_circle() {
    let found = circles_of(&[
        ("lib.rs", "mod parent;"),
        (
            "parent/mod.rs",
            "mod child; pub enum Error { No } pub fn f() { child::g(); }",
        ),
        (
            "parent/child.rs",
            "pub fn g() -> Result<(), super::Error> { Ok(()) }",
        ),
    ]);
    assert_eq!(found.len(), 1);
    assert_eq!(
        names(&found[0], "parent/child.rs", "parent/mod.rs"),
        "Error"
    );
    assert_eq!(names(&found[0], "parent/mod.rs", "parent/child.rs"), "g");
}

#[test]
fn a_parent_that_re_exports_what_its_children_share_is_no_circle() {
    let found = circles_of(&[
        ("lib.rs", "mod parent;"),
        ("parent/mod.rs", "mod a; mod b; pub use a::A; pub use b::*;"),
        ("parent/a.rs", "pub struct A;"),
        ("parent/b.rs", "use super::A; pub struct B(A);"),
    ]);
    assert_eq!(found, []);
}

#[test]
fn a_re_export_that_the_parent_itself_uses_counts() {
    let found = circles_of(&[
        ("lib.rs", "mod parent;"),
        (
            "parent/mod.rs",
            "mod a; pub use a::A; pub struct P; pub fn make() -> A { A }",
        ),
        ("parent/a.rs", "use super::P; pub struct A; fn a(_: P) {}"),
    ]);
    assert_eq!(found.len(), 1);
}

#[test]
fn names_through_renames_globs_and_inline_modules_are_followed() {
    let found = circles_of(&[
        (
            "lib.rs",
            "mod a; mod b; mod names { pub use crate::a::Thing as Other; }",
        ),
        (
            "a.rs",
            "use crate::b::*; pub struct Thing; fn a() { work() }",
        ),
        (
            "b.rs",
            "use crate::names::Other; pub fn work() {} fn b(_: Other) {}",
        ),
    ]);
    assert_eq!(found.len(), 1);
    assert_eq!(names(&found[0], "a.rs", "b.rs"), "work");
    assert_eq!(names(&found[0], "b.rs", "a.rs"), "Thing");
}

#[test]
fn macros_count_where_they_are_called_and_for_what_they_are_given() {
    let found = circles_of(&[
        ("lib.rs", "#[macro_use] mod a; mod b;"),
        (
            "a.rs",
            "macro_rules! twice { ($x:expr) => { $x + $x } } fn a() { assert!(crate::b::b()) }",
        ),
        ("b.rs", "pub fn b() -> bool { twice!(1) == 2 }"),
    ]);
    assert_eq!(found.len(), 1);
    assert_eq!(names(&found[0], "b.rs", "a.rs"), "twice!");
}

#[test]
fn tests_do_not_count() {
    let found = circles_of(&[
        ("lib.rs", "mod a; mod b; #[cfg(test)] mod tests;"),
        (
            "a.rs",
            "pub fn a() {} #[cfg(test)] mod tests { use crate::b::b; #[test] fn t() { b() } }",
        ),
        ("b.rs", "use crate::a::a; pub fn b() { a() }"),
        ("tests.rs", "use crate::b::b; fn t() { b() }"),
    ]);
    assert_eq!(found, []);
}

#[test]
fn variables_hide_the_names_of_other_files() {
    let found = circles_of(&[
        ("lib.rs", "mod a; mod b;"),
        (
            "a.rs",
            "use crate::b::*; pub struct A; fn a(rest: i32) -> i32 { rest }",
        ),
        ("b.rs", "use crate::a::A; pub fn rest(_: A) {}"),
    ]);
    assert_eq!(found, []);
}

#[test]
fn an_absent_file_is_an_error() {
    let folder = tempfile::tempdir().expect("there is a temporary folder");
    fs::write(folder.path().join("lib.rs"), "mod gone;").expect("the file can be written");
    let error = circles(folder.path()).expect_err("the module has no file");
    assert!(
        error
            .to_string()
            .ends_with("lib.rs: the module `gone` has no file"),
        "{error}"
    );
}

#[test]
fn names_that_a_parent_hands_on_are_those_of_the_file_that_defines_them() {
    // The error names the view as the parent hands it on, and the parent uses the error.
    let found = circles_of(&[
        ("lib.rs", "pub mod pose; mod error;"),
        (
            "pose/mod.rs",
            "mod view; pub use view::View; use crate::error::Error; \
             pub fn pose() -> Result<(), Error> { Ok(()) }",
        ),
        ("pose/view.rs", "pub enum View { Left }"),
        ("error.rs", "use crate::pose::View; pub struct Error(View);"),
    ]);
    assert_eq!(found, []);

    // Through two parents, and from a child that uses its grandparent's names.
    let found = circles_of(&[
        ("lib.rs", "mod a; pub use a::Leaf; pub struct Root;"),
        ("a/mod.rs", "mod b; pub use b::{Leaf, other};"),
        (
            "a/b/mod.rs",
            "mod leaf; mod other; pub use leaf::Leaf; pub use other::*;",
        ),
        (
            "a/b/leaf.rs",
            "pub struct Leaf; fn l() { crate::a::other() }",
        ),
        (
            "a/b/other.rs",
            "use crate::Leaf; pub fn other() { let _ = Leaf; }",
        ),
    ]);
    assert_eq!(found.len(), 1);
    assert_eq!(names(&found[0], "a/b/leaf.rs", "a/b/other.rs"), "other");
    assert_eq!(names(&found[0], "a/b/other.rs", "a/b/leaf.rs"), "Leaf");
}
