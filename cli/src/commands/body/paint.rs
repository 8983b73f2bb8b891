//! `nullcone body paint`: dots on the skin of a character.

use std::path::PathBuf;

use anyhow::{Context as _, Result};
use ga_mesh::gltf;
use serde::Serialize;

use crate::format::Format;
use crate::frame::{Command, Context, Shown};
use crate::person::{DottedCharacter, at_rest};
use crate::shell::quoted;

/// Paint coloured dots on the skin of a character, by which cameras find its pose.
///
/// About 480 dots of 9.5 to 15 mm in radius are on the skin of an adult, each in one of six hues,
/// at random but for those of its neighbours; the rest is grey. The result is binary glTF in the
/// pose of rest, which `clip retarget --target` moves and `render` draws. `nullcone body dots`
/// finds the dots in films of the character.
///
/// The mannequin has the dots in its texture. On another character they are thin discs that lie on
/// the skin and move with it; the result has its joints, but not its materials and animations.
///
/// For instance
///
///   nullcone body paint --out dotted.glb
///   nullcone clip retarget walk.bvh --target dotted.glb --out walking.glb
///   nullcone render walking.glb --camera views.json --view front --film front.y4m
///   nullcone body paint --character hero.glb --out dotted-hero.glb
///
/// --json prints {"character": "mannequin", "out": "dotted.glb", "seed": 1, "dots": …}.
#[derive(Clone, Debug, clap::Args)]
#[command(verbatim_doc_comment)]
pub(crate) struct Arguments {
    #[command(flatten)]
    character: DottedCharacter,
    /// The file to be written.
    #[arg(long, value_name = "OUT.glb")]
    out: PathBuf,
}

/// Rows and columns of the painted skin: a texel is about 1 mm, a twentieth of a dot.
const TEXTURE_SIZE: usize = 2048;

#[derive(Serialize)]
pub(crate) struct Painted {
    character: String,
    out: String,
    seed: u64,
    dots: usize,
}

impl Command for Arguments {
    type Report = Shown<Painted>;

    fn run(&self, context: &Context) -> Result<Self::Report> {
        let mut files = context.files(self.character.path())?;
        files.write("--out", &self.out, &[Format::Glb])?;
        let progress = context.progress(2);
        progress.step("painting");
        let dotted = self.character.read()?;
        let values = Painted {
            character: dotted.name().to_owned(),
            out: self.out.display().to_string(),
            seed: self.character.seed(),
            dots: dotted.count(),
        };
        let (figure, warning) = dotted.into_figure(TEXTURE_SIZE)?;
        let mut document = at_rest(&figure)?;
        document.animations.clear();
        progress.step("writing");
        let contents = gltf::encode(&document).context("the character cannot be written")?;
        context.outputs().write(&self.out, &contents)?;
        drop(progress);
        let Painted {
            character,
            out,
            dots,
            ..
        } = &values;
        let text = format!("{out}: the {character} with {dots} dots\n");
        let target = quoted(&self.out);
        let next = Format::Glb.fits(&self.out);
        let next = next.then(|| format!("nullcone render {target} --out dotted.png"));
        Ok(Shown {
            next,
            warnings: warning.map(|warning| vec![warning]),
            ..Shown::new(values, text)
        })
    }
}
