//! The `ga!` blocks of a text, and which of them use functions of which others.

use proc_macro2::{Ident, TokenStream};
use syn::{Error, Result};

use crate::parse::{Block, FunctionSyntax, Import, UseSyntax, parse_functions, parse_use};

/// A block before the functions that it uses are found.
struct Unlinked {
    /// The modules around it in its file, outermost first.
    modules: Vec<String>,
    uses: Vec<UseSyntax>,
    functions: Vec<FunctionSyntax>,
}

/// Reads blocks, given as the modules around each and its tokens, and joins each with the functions
/// of others that it uses.
///
/// # Errors
/// The tokens leave the grammar, two functions have one name, or a used function is in none of the
/// blocks.
pub(super) fn link(blocks: Vec<(Vec<String>, TokenStream)>) -> Result<Vec<Block>> {
    let mut unlinked = Vec::new();
    for (modules, tokens) in blocks {
        unlinked.push(read(modules, tokens)?);
    }
    check_names(&unlinked)?;
    (0..unlinked.len())
        .map(|index| linked(&unlinked, &mut vec![index]))
        .collect()
}

fn read(modules: Vec<String>, tokens: TokenStream) -> Result<Unlinked> {
    let (mut uses, mut rest) = (Vec::new(), tokens);
    loop {
        let (first, follows) = parse_use(rest)?;
        rest = follows;
        match first {
            Some(first) => uses.push(first),
            None => break,
        }
    }
    Ok(Unlinked {
        modules,
        uses,
        functions: parse_functions(rest)?,
    })
}

/// The names of functions tell them apart in what is printed.
fn check_names(blocks: &[Unlinked]) -> Result<()> {
    let names = |block: &Unlinked| -> Vec<Ident> {
        let functions = block.functions.iter();
        functions
            .filter_map(|function| function.name.clone())
            .collect()
    };
    for (index, block) in blocks.iter().enumerate() {
        let earlier: Vec<Ident> = blocks[..index].iter().flat_map(names).collect();
        if let Some(name) = names(block).iter().find(|name| earlier.contains(name)) {
            let message = format!(
                "an earlier `ga!` block has a function `{name}`; the functions of all blocks are printed together"
            );
            return Err(Error::new(name.span(), message));
        }
    }
    Ok(())
}

/// The block at the end of a path of blocks, each used by the one before.
fn linked(blocks: &[Unlinked], path: &mut Vec<usize>) -> Result<Block> {
    let Some(block) = path.last().map(|&index| &blocks[index]) else {
        return Ok(Block::default());
    };
    let mut imports = Vec::new();
    for used in &block.uses {
        let Some(target) = blocks.iter().position(|block| block.answers(used)) else {
            let name = &used.original;
            let message = format!(
                "the function `{name}` is not in a `ga!` block of this file; \
                 functions of other files cannot be used here"
            );
            return Err(Error::new(name.span(), message));
        };
        if path.contains(&target) {
            let message = "these `ga!` blocks use functions of each other in a circle";
            return Err(Error::new(used.original.span(), message));
        }
        path.push(target);
        imports.push(Import {
            name: used.name.clone(),
            original: used.original.clone(),
            block: linked(blocks, path)?,
        });
        path.pop();
    }
    Ok(Block {
        functions: block.functions.clone(),
        imports,
    })
}

impl Unlinked {
    /// Whether a path may name a function of this block. Where its file belongs in its crate is not
    /// known: of the modules in the path and of those around the block, the shorter list must end
    /// the longer.
    fn answers(&self, used: &UseSyntax) -> bool {
        let is_relative = |name: &String| ["crate", "self", "super"].contains(&name.as_str());
        let mut segments: Vec<String> = used
            .path
            .segments
            .iter()
            .map(|segment| segment.ident.to_string())
            .skip_while(is_relative)
            .collect();
        segments.pop();
        let ends = segments.ends_with(&self.modules) || self.modules.ends_with(&segments);
        let mut names = self
            .functions
            .iter()
            .filter_map(|function| function.name.as_ref());
        ends && names.any(|name| *name == used.original)
    }
}
