fn main() -> std::process::ExitCode {
    effigy::cli::main()
}
