//! `nullcone man`: manual pages.

use std::path::PathBuf;

use anyhow::Result;
use clap::Command;
use clap_mangen::Man;

use crate::files::Files;
use crate::output;

/// Print the manual page of the program, or write a page for each command into a folder.
#[derive(Clone, Debug, clap::Args)]
pub(crate) struct Arguments {
    /// The folder for the pages of all commands, such as nullcone-body-fit.1.
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
}

pub(crate) fn run(arguments: &Arguments, command: Command, quiet: bool) -> Result<()> {
    let mut command = command.disable_help_subcommand(true);
    command.build();
    let Some(folder) = &arguments.out else {
        return output::print(&String::from_utf8(page(&Man::new(command))?)?);
    };
    let mut pages = Vec::new();
    add_pages(command, &mut pages)?;
    let mut files = Files::default();
    files.write_folder("--out", folder, pages.iter().map(|(name, _)| name))?;
    let count = pages.len();
    let pages = pages.into_iter();
    output::write_together(pages.map(|(name, contents)| (folder.join(name), contents)))?;
    if !quiet {
        output::print(&format!("wrote {count} pages into {}\n", folder.display()))?;
    }
    Ok(())
}

/// Adds the name and the contents of the page of a command, and of those below it.
fn add_pages(command: Command, pages: &mut Vec<(String, Vec<u8>)>) -> Result<()> {
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
