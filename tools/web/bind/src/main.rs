//! bind IN.wasm OUT_DIR NAME: what the command `wasm-bindgen --target web` does, where that is not
//! installed.

use anyhow::{Context, ensure};

fn main() -> anyhow::Result<()> {
    let arguments: Vec<String> = std::env::args().collect();
    ensure!(arguments.len() == 4, "usage: bind IN.wasm OUT_DIR NAME");
    let mut bindgen = wasm_bindgen_cli_support::Bindgen::new();
    bindgen.input_path(&arguments[1]).web(true)?.typescript(false).out_name(&arguments[3]);
    bindgen.remove_name_section(true).remove_producers_section(true);
    bindgen.generate(&arguments[2]).with_context(|| format!("{} can't be bound", arguments[1]))
}
