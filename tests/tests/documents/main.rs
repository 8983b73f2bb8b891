//! The documents of the repository: what they name exists, and every crate has a page.

mod paper;
mod sources;

use std::fs;
use std::path::{Path, PathBuf};

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .parent()
        .expect("a folder around the tests")
}

/// The folders of the workspace's crates that are not tests or benchmarks.
fn crates() -> Vec<PathBuf> {
    let mut folders: Vec<PathBuf> = ["anim", "body", "cli", "ga-macros", "ga-runtime"]
        .into_iter()
        .chain(["video", "vision"])
        .map(|folder| root().join(folder))
        .collect();
    for group in ["compiler", "foundation"] {
        let entries = fs::read_dir(root().join(group)).expect("a folder");
        let entries = entries.map(|entry| entry.expect("an entry").path());
        folders.extend(entries.filter(|path| path.join("Cargo.toml").exists()));
    }
    folders
}

/// The page of the architecture, and the page of each crate.
fn pages() -> Vec<PathBuf> {
    let crates = crates();
    assert!(crates.len() >= 17);
    let pages = crates.iter().map(|folder| folder.join("README.md"));
    std::iter::once(root().join("ARCHITECTURE.md"))
        .chain(pages)
        .collect()
}

/// A page without its blocks of code.
fn prose(page: &Path) -> String {
    let text = fs::read_to_string(page).unwrap_or_else(|error| panic!("{page:?}: {error}"));
    let parts = text.split("\n```");
    parts.step_by(2).collect::<Vec<_>>().join("\n")
}

/// The parts of a text between backticks that are paths.
fn paths(text: &str) -> impl Iterator<Item = &str> {
    let is_path = |code: &&str| code.contains('/') && !code.contains(' ');
    text.split('`').skip(1).step_by(2).filter(is_path)
}

/// Where the links of a text lead to, without those to other sites and to places of the same page.
fn links(text: &str) -> impl Iterator<Item = &str> {
    text.split("](").skip(1).filter_map(|rest| {
        let target = rest.split(')').next()?;
        let target = target.split('#').next()?;
        (!target.is_empty() && !target.contains("://")).then_some(target)
    })
}

/// Paths are of the repository, of the crate, or of its sources.
#[test]
fn paths_exist() {
    let mut count = 0;
    for page in pages() {
        let folder = page.parent().expect("a folder");
        for path in prose(&page).split('\n').flat_map(paths) {
            count += 1;
            let exists = [root(), folder, &folder.join("src")]
                .iter()
                .any(|base| base.join(path).exists());
            assert!(exists, "{} names {path}", page.display());
        }
    }
    assert!(count > 100, "{count} paths");
}

#[test]
fn links_lead_to_files() {
    let mut all = pages();
    for name in ["README.md", "CONTRIBUTING.md", "CHANGELOG.md"] {
        all.push(root().join(name));
    }
    let entries = fs::read_dir(root().join("docs")).expect("a folder");
    let entries = entries.map(|entry| entry.expect("an entry").path());
    all.extend(entries.filter(|path| path.extension().is_some_and(|ending| ending == "md")));
    for page in all {
        let folder = page.parent().expect("a folder");
        for link in links(&prose(&page)) {
            assert!(
                folder.join(link).exists(),
                "{} links to {link}",
                page.display()
            );
        }
    }
}

#[test]
fn the_architecture_lists_every_crate() {
    let architecture = prose(&root().join("ARCHITECTURE.md"));
    let listed: Vec<&str> = links(&architecture)
        .filter(|link| link.ends_with("/README.md"))
        .collect();
    for folder in crates() {
        let folder = folder
            .strip_prefix(root())
            .expect("a folder of the workspace");
        let page = folder.join("README.md");
        assert!(
            listed.iter().any(|link| Path::new(link) == page),
            "ARCHITECTURE.md does not link to {}",
            page.display()
        );
    }
}

/// The crates of the workspace that a manifest names as dependencies, without `ga-`.
fn dependencies(folder: &Path) -> Vec<String> {
    let manifest = fs::read_to_string(folder.join("Cargo.toml")).expect("a manifest");
    let section = manifest
        .split("\n[")
        .find(|part| part.starts_with("dependencies]"));
    let lines = section.unwrap_or_default().lines();
    let names = lines.filter_map(|line| line.strip_prefix("ga-")?.split(['.', ' ']).next());
    let names = names.filter(|name| !["files", "runtime"].contains(name));
    names.map(str::to_owned).collect()
}

/// The arrows between the crates on the engine are those of their manifests.
#[test]
fn arrows_are_the_dependencies() {
    let text = fs::read_to_string(root().join("ARCHITECTURE.md")).expect("a page");
    let mut drawn: Vec<(&str, Vec<&str>)> = text
        .lines()
        .filter_map(|line| line.split_once(" ──► "))
        .filter(|(from, _)| !from.starts_with("ga-"))
        .map(|(from, to)| {
            let to = to.split(" (").next().unwrap_or(to);
            (from.trim(), to.split(", ").collect())
        })
        .collect();
    drawn.sort();
    let mut found = Vec::new();
    for folder in crates() {
        let name = folder.file_name().expect("a name").to_string_lossy();
        let is_on_the_engine = !name.starts_with("ga-") && name != "cli";
        let mut to = dependencies(&folder);
        to.sort();
        if is_on_the_engine && !to.is_empty() {
            found.push((name.into_owned(), to));
        }
    }
    found.sort();
    let found: Vec<(&str, Vec<&str>)> = found
        .iter()
        .map(|(name, to)| (name.as_str(), to.iter().map(String::as_str).collect()))
        .collect();
    assert_eq!(drawn, found);
}

/// A table is read at a glance: no cell is a paragraph.
#[test]
fn cells_of_tables_are_short() {
    let paper = root().join("docs/paper.md");
    for page in pages().into_iter().chain([paper]) {
        for line in prose(&page).lines().filter(|line| line.starts_with('|')) {
            for cell in line.split(" | ") {
                let length = cell.chars().count();
                assert!(length <= 160, "{}: {cell}", page.display());
            }
        }
    }
}
