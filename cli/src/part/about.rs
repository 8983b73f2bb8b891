//! What a part is of.

use std::fs::File;
use std::io::{self, Write};
use std::ops::Range;
use std::path::Path;

use anyhow::{Context as _, Result, bail, ensure};
use crc32fast::Hasher;
use serde::{Deserialize, Serialize};
use serde_json::Value;

use crate::standard_output::is_dash;

/// The command that made a part, what it read, and which frames the part has.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct About {
    /// The words of the command, as `quality compare`.
    pub(crate) command: String,
    /// The version of the program: another one may compute other numbers.
    pub(crate) program: String,
    /// The arguments on which the result depends.
    pub(crate) options: Value,
    pub(crate) inputs: Vec<Input>,
    /// The first frame, and the one after the last.
    pub(crate) frames: [usize; 2],
    /// Whether no frame comes after them.
    pub(crate) is_last: bool,
}

/// A file that was read, or one of a folder.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct Input {
    pub(crate) file: String,
    pub(crate) bytes: u64,
    /// The checksum of zip and PNG: films without compression that differ have the same size.
    pub(crate) crc_32: u32,
}

impl About {
    /// A part of what a command makes of these inputs.
    pub(crate) fn new<'a>(
        command: &str,
        arguments: &impl Serialize,
        inputs: impl IntoIterator<Item = &'a Path>,
        frames: Range<usize>,
        is_last: bool,
    ) -> Result<Self> {
        let mut found = Vec::new();
        for path in inputs {
            Input::add(path, &mut found)?;
        }
        Ok(Self {
            command: command.to_owned(),
            program: env!("CARGO_PKG_VERSION").to_owned(),
            options: serde_json::to_value(arguments)?,
            inputs: found,
            frames: [frames.start, frames.end],
            is_last,
        })
    }

    /// In what the work of another part differs, but for the frames, in words.
    pub(super) fn difference(&self, other: &Self) -> Option<String> {
        let differ = |what: &str, own: &str, others: &str| {
            (own != others).then(|| format!("{what} is {own:?} and {others:?}"))
        };
        differ("the command", &self.command, &other.command)
            .or_else(|| differ("the version of nullcone", &self.program, &other.program))
            .or_else(|| self.difference_of_options(&other.options))
            .or_else(|| self.difference_of_inputs(&other.inputs))
    }

    fn difference_of_options(&self, other: &Value) -> Option<String> {
        let none = serde_json::Map::new();
        let [own, others] = [&self.options, other].map(|all| all.as_object().unwrap_or(&none));
        let names = own.keys().chain(others.keys());
        let shown = |value: Option<&Value>| match value {
            None | Some(Value::Null) => "not given".to_owned(),
            Some(value) => value.to_string(),
        };
        let difference = |name: &String| {
            let [own, others] = [own, others].map(|all| shown(all.get(name)));
            let name = name.replace('_', "-");
            (own != others).then(|| format!("the argument {name} is {own} and {others}"))
        };
        names.into_iter().find_map(difference)
    }

    fn difference_of_inputs(&self, other: &[Input]) -> Option<String> {
        let pairs = self.inputs.iter().zip(other);
        let difference = |(own, other): (&Input, &Input)| {
            if own.file != other.file {
                return Some(format!("they read {} and {}", own.file, other.file));
            }
            (own != other).then(|| format!("{} was another file", own.file))
        };
        let counts = [self.inputs.len(), other.len()];
        pairs.into_iter().find_map(difference).or_else(|| {
            let [own, other] = counts;
            (own != other).then(|| format!("they read {own} and {other} files"))
        })
    }
}

impl Input {
    /// Adds a file, or those of a folder in the order of their names.
    fn add(path: &Path, all: &mut Vec<Self>) -> Result<()> {
        let named = || format!("cannot read {}", path.display());
        if is_dash(path) {
            bail!("-: standard input can be read by one process only, and --frames is for several");
        }
        if path.is_dir() {
            let entries = path.read_dir().with_context(named)?;
            let entries: io::Result<Vec<_>> = entries.map(|entry| Ok(entry?.path())).collect();
            let mut entries = entries.with_context(named)?;
            entries.retain(|path| path.is_file());
            entries.sort();
            return entries.iter().try_for_each(|path| Self::add(path, all));
        }
        let (bytes, crc_32) = checksum(path)?;
        all.push(Self {
            file: path.display().to_string(),
            bytes,
            crc_32,
        });
        Ok(())
    }

    /// Fails where the file is no longer what it was.
    pub(super) fn check(&self) -> Result<()> {
        let found = checksum(Path::new(&self.file))?;
        ensure!(
            found == (self.bytes, self.crc_32),
            "{}: the file has changed since the parts were made",
            self.file
        );
        Ok(())
    }
}

/// How many bytes a file has, and their CRC-32.
fn checksum(path: &Path) -> Result<(u64, u32)> {
    struct Sum(Hasher);

    impl Write for Sum {
        fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
            self.0.update(bytes);
            Ok(bytes.len())
        }

        fn flush(&mut self) -> io::Result<()> {
            Ok(())
        }
    }

    let mut sum = Sum(Hasher::new());
    let read = File::open(path).and_then(|mut file| io::copy(&mut file, &mut sum));
    let bytes = read.with_context(|| format!("cannot read {}", path.display()))?;
    Ok((bytes, sum.0.finalize()))
}
