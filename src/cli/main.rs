//! The binary `effigy`; [`effigy_cli`] has the command line.

fn main() -> std::process::ExitCode {
    effigy_cli::main()
}
