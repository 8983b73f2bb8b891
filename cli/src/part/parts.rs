//! Parts that belong together.

use std::path::{Path, PathBuf};

use anyhow::{Context as _, Result, anyhow, bail, ensure};
use serde::de::DeserializeOwned;

use super::about::{About, Input};
use super::file;

/// Parts of the same work, in the order of their frames, which are all that there are.
pub(crate) struct Parts(Vec<(PathBuf, About)>);

impl Parts {
    /// Reads what parts are of. A film stands for the part that lies beside it.
    ///
    /// # Errors
    ///
    /// [`anyhow::Error`]: a file is not a part; two are of other work or have frames in common;
    /// frames are missing.
    pub(crate) fn read(paths: &[PathBuf]) -> Result<Self> {
        let mut all: Vec<(PathBuf, About)> = Vec::new();
        for path in paths {
            let path = match path.extension().is_some_and(|ending| ending == "json") {
                true => path.clone(),
                false => super::beside(path),
            };
            // A pattern may match both a film and what lies beside it.
            if all.iter().all(|(other, _)| *other != path) {
                let about = file::about(&path)?;
                all.push((path, about));
            }
        }
        all.sort_by_key(|(_, about)| about.frames);
        let Some((first, about)) = all.first() else {
            bail!("no part is given");
        };
        for (path, other) in &all[1..] {
            if let Some(difference) = about.difference(other) {
                let [first, path] = [first, path].map(|path| path.display());
                bail!("{first} and {path} are parts of other work: {difference}");
            }
        }
        let mut end = 0;
        let mut before: Option<&Path> = None;
        for (path, about) in &all {
            let [first, next] = about.frames;
            if let Some(before) = before.filter(|_| first < end) {
                bail!(
                    "{} and {} both have the frames {first}..{}",
                    before.display(),
                    path.display(),
                    end.min(next)
                );
            }
            ensure!(
                first == end,
                "no part has the frames {end}..{first}: {} is the next",
                path.display()
            );
            (before, end) = (Some(path.as_path()), next);
        }
        let last = all.last().filter(|(_, about)| about.is_last);
        ensure!(last.is_some(), "no part has the frames {end}.. at the end");
        Ok(Self(all))
    }

    /// What all of them are of.
    pub(crate) fn about(&self) -> Result<&About> {
        let (_, first) = self.0.first().ok_or_else(|| anyhow!("no part is given"))?;
        Ok(first)
    }

    /// How many frames all parts have together.
    pub(crate) fn frames(&self) -> usize {
        self.0.last().map_or(0, |(_, about)| about.frames[1])
    }

    /// Fails where an input is no longer what it was.
    pub(crate) fn check_inputs(&self) -> Result<()> {
        let about = self.about()?;
        about.inputs.iter().try_for_each(Input::check)
    }

    /// The arguments of the command that made them.
    pub(crate) fn arguments<A: DeserializeOwned>(&self) -> Result<A> {
        let about = self.about()?;
        let arguments = serde_json::from_value(about.options.clone());
        arguments.with_context(|| format!("the arguments of {} are damaged", about.command))
    }

    /// What was found in each part, with its file.
    pub(crate) fn contents<C: DeserializeOwned>(
        &self,
    ) -> impl ExactSizeIterator<Item = Result<(&Path, C)>> {
        self.0
            .iter()
            .map(|(path, _)| Ok((path.as_path(), file::contents(path)?)))
    }

    /// The files of the parts.
    pub(crate) fn paths(&self) -> impl ExactSizeIterator<Item = &Path> {
        self.0.iter().map(|(path, _)| path.as_path())
    }
}
