//! `nullcone body paint`: dots on the skin of a character.

use std::path::{Path, PathBuf};

use anyhow::{Context as _, Result, ensure};
use ga_mesh::gltf;
use serde::Serialize;

use crate::format::Format;
use crate::frame::{Command, Context, Shown};
use crate::person::{CharacterFile, Dotted, HueSeed, MANNEQUIN, at_rest};
use crate::shell::quoted;

/// Paint coloured dots on the skin of a character, by which cameras find its pose.
///
/// About 480 dots of 9.5 to 15 mm in radius are on the skin, each in one of six hues, at random but
/// for those of its neighbours; the rest is grey. The result is binary glTF in the pose of rest,
/// which `clip retarget --target` moves and `render` draws. `nullcone body dots` finds the dots in
/// films of the character. Only the mannequin knows where on its skin dots are.
///
/// For instance
///
///   nullcone body paint --out dotted.glb
///   nullcone clip retarget walk.bvh --target dotted.glb --out walking.glb
///   nullcone render walking.glb --camera views.json --view front --film front.y4m
///
/// --json prints {"character": "mannequin", "out": "dotted.glb", "seed": 1, "dots": …}.
#[derive(Clone, Debug, clap::Args)]
#[command(verbatim_doc_comment)]
pub(crate) struct Arguments {
    /// The character: `mannequin`, the person of `nullcone demo`.
    #[arg(long, value_name = "mannequin", default_value = MANNEQUIN)]
    character: PathBuf,
    /// The file to be written.
    #[arg(long, value_name = "OUT.glb")]
    out: PathBuf,
    #[command(flatten)]
    seed: HueSeed,
}

/// Rows and columns of the painted skin: a texel is about 1 mm, a twentieth of a dot.
const TEXTURE_SIZE: usize = 2048;

#[derive(Serialize)]
pub(crate) struct Painted {
    character: &'static str,
    out: String,
    seed: u64,
    dots: usize,
}

impl Command for Arguments {
    type Report = Shown<Painted>;

    fn run(&self, context: &Context) -> Result<Self::Report> {
        ensure!(
            CharacterFile(&self.character).path().is_none(),
            "--character {}: only {MANNEQUIN} knows where on its skin dots are",
            self.character.display()
        );
        let no_inputs: [&Path; 0] = [];
        let mut files = context.files(no_inputs)?;
        files.write("--out", &self.out, &[Format::Glb])?;
        let progress = context.progress(2);
        progress.step("painting");
        let dotted = Dotted::new(self.seed);
        let values = Painted {
            character: MANNEQUIN,
            out: self.out.display().to_string(),
            seed: self.seed.seed,
            dots: dotted.count(),
        };
        let mut document = at_rest(&dotted.into_figure(TEXTURE_SIZE))?;
        document.animations.clear();
        progress.step("writing");
        let contents = gltf::encode(&document).context("the character cannot be written")?;
        context.outputs().write(&self.out, &contents)?;
        drop(progress);
        let Painted { out, dots, .. } = &values;
        let text = format!("{out}: the {MANNEQUIN} with {dots} dots\n");
        let target = quoted(&self.out);
        let next = Format::Glb.fits(&self.out);
        let next = next.then(|| format!("nullcone render {target} --out dotted.png"));
        Ok(Shown {
            next,
            ..Shown::new(values, text)
        })
    }
}
