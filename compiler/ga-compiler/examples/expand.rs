//! Prints the Rust code of an algebra. The declaration is read from a file, or from standard input:
//! `cargo run -p ga-compiler --example expand -- FILE`.

use std::io::Read;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut text = String::new();
    match std::env::args().nth(1) {
        Some(path) => text = std::fs::read_to_string(path)?,
        None => {
            std::io::stdin().read_to_string(&mut text)?;
        }
    }
    let declaration: proc_macro2::TokenStream = text.parse()?;
    let code = ga_compiler::expand_algebra(quote::quote! { [::ga_runtime] #declaration });
    let file = syn::parse2(code)?;
    println!("{}", prettyplease::unparse(&file));
    Ok(())
}
