fn main() -> std::process::ExitCode {
    effigy_cli::main()
}
