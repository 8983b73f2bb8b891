//! `nullcone man`: manual pages.

use std::path::PathBuf;

use anyhow::Result;
use clap_mangen::Man;
use serde::Serialize;

use crate::frame::{self, Command, Context};

/// Print the manual page of the program, or write a page for each command into a folder.
///
/// --json prints {"page": …}, or, with --out, {"files": […]}.
#[derive(Clone, Debug, clap::Args)]
pub(crate) struct Arguments {
    /// The folder for the pages of all commands, such as nullcone-body-fit.1.
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
}

/// The command together with the program that the pages are about.
pub(crate) struct Manual<'a> {
    pub(crate) arguments: &'a Arguments,
    pub(crate) program: clap::Command,
}

/// What is printed.
#[derive(Serialize)]
#[serde(untagged)]
pub(crate) enum Report {
    Page {
        page: String,
    },
    Written {
        #[serde(skip)]
        folder: PathBuf,
        files: Vec<String>,
    },
}

impl Command for Manual<'_> {
    type Report = Report;

    fn run(&self, context: &Context) -> Result<Report> {
        let mut files = context.files::<&str>([])?;
        let mut program = self.program.clone().disable_help_subcommand(true);
        program.build();
        let Some(folder) = &self.arguments.out else {
            let page = String::from_utf8(page(&Man::new(program))?)?;
            return Ok(Report::Page { page });
        };
        let mut pages = Vec::new();
        add_pages(program, &mut pages)?;
        files.write_folder("--out", folder, pages.iter().map(|(name, _)| name))?;
        let mut files = Vec::with_capacity(pages.len());
        for (name, page) in pages {
            let path = folder.join(name);
            context.outputs().write(&path, page)?;
            files.push(path.display().to_string());
        }
        Ok(Report::Written {
            folder: folder.clone(),
            files,
        })
    }
}

impl frame::Report for Report {
    fn text(&self) -> String {
        match self {
            Self::Page { page } => page.clone(),
            Self::Written { folder, files } => {
                format!("wrote {} pages into {}\n", files.len(), folder.display())
            }
        }
    }

    fn is_result(&self) -> bool {
        matches!(self, Self::Page { .. })
    }
}

/// Adds the name and the contents of the page of a command, and of those below it.
fn add_pages(command: clap::Command, pages: &mut Vec<(String, Vec<u8>)>) -> Result<()> {
    for below in command.get_subcommands().cloned() {
        add_pages(below, pages)?;
    }
    let man = Man::new(command);
    pages.push((man.get_filename(), page(&man)?));
    Ok(())
}

fn page(man: &Man) -> Result<Vec<u8>> {
    let mut page = Vec::new();
    man.render(&mut page)?;
    Ok(page)
}
