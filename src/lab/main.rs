//! The binary `effigy-lab`; [`effigy_lab`] has its commands.

fn main() -> std::process::ExitCode {
    effigy_lab::main()
}
