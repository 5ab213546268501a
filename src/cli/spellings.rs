//! One name per option: old spellings keep working for one version, hidden from help, and an option
//! of one name is described the same way wherever it means the same.

use crate::{Cli, command};
use clap::{Arg, Command, FromArgMatches};
use std::collections::BTreeMap;

/// The parsed arguments as text, to compare them.
fn parse(arguments: &str) -> Result<String, clap::Error> {
    let words = ["effigy"].into_iter().chain(arguments.split_whitespace());
    let matches = command().try_get_matches_from(words)?;
    Cli::from_arg_matches(&matches).map(|cli| format!("{cli:?}"))
}

/// Old spellings, each with the new one. CHANGELOG.md lists them.
const OLD: [(&str, &str); 8] = [
    ("view --raster hulls", "view --raster quads"),
    ("render --least", "render --baseline"),
    ("render --sort selfscan", "render --sort reduce-then-scan"),
    ("render --sort lanescan", "render --sort per-thread"),
    (
        "bake motion a.bvh --out a.motion --rate 30",
        "bake motion a.bvh --out a.motion --fps 30",
    ),
    (
        "pack --out a.avatar --pictures 2",
        "pack --out a.avatar --frames 2",
    ),
    (
        "export-ply --out a.ply --at 1.5",
        "export-ply --out a.ply --time 1.5",
    ),
    (
        "export-ply --out a.ply --cameras c.json --views 3",
        "export-ply --out a.ply --cameras-out c.json --views 3",
    ),
];

#[test]
fn old_spellings_mean_what_the_new_ones_do() {
    for (old, new) in OLD {
        let parsed = parse(new).unwrap_or_else(|error| panic!("effigy {new}: {error}"));
        assert_eq!(parse(old).ok(), Some(parsed), "effigy {old}");
    }
}

#[test]
fn old_options_without_a_new_name_still_parse() {
    for old in [
        "soak --governor off",
        "soak --compare a.json b.json",
        "dataset a.motion --pictures --out a.capture",
    ] {
        assert!(parse(old).is_ok(), "effigy {old}");
    }
}

#[test]
fn help_shows_no_old_spelling() {
    let mut help = String::new();
    for_each_command(&mut command(), &mut |command| {
        help += &command.render_long_help().to_string();
    });
    for old in [
        "hulls",
        "selfscan",
        "lanescan",
        "--least",
        "--smallest",
        "--largest",
        "--at ",
        "--rate",
        "--compare",
    ] {
        assert!(!help.contains(old), "help shows {old}");
    }
}

fn for_each_command(command: &mut Command, visit: &mut dyn FnMut(&mut Command)) {
    command.build();
    visit(command);
    for subcommand in command.get_subcommands_mut() {
        for_each_command(subcommand, visit);
    }
}

/// Options whose meaning depends on the command.
const OWN_MEANING: [&str; 20] = [
    "background",
    "cameras",
    "case",
    "compare",
    "fps",
    "frames",
    "help",
    "json",
    "keys",
    "minutes",
    "motion",
    "out",
    "parts",
    "person",
    "pictures",
    "rows",
    "samples",
    "size",
    "sort",
    "yaw",
];

#[test]
fn an_option_is_described_alike_in_all_commands() {
    let mut first: BTreeMap<String, String> = BTreeMap::new();
    let mut differences = Vec::new();
    for_each_command(&mut command(), &mut |command| {
        for option in command.get_arguments().filter(|arg| is_shared(arg)) {
            let long = option.get_long().unwrap_or_default();
            let help = option.get_help().map(ToString::to_string);
            let description = format!(
                "{:?} {}",
                option.get_value_names(),
                help.unwrap_or_default()
            );
            let known = first
                .entry(long.to_owned())
                .or_insert_with(|| description.clone());
            if description != *known {
                let name = command.get_name();
                differences.push(format!("--{long} of {name}: {description}, not {known}"));
            }
        }
    });
    assert!(differences.is_empty(), "{}", differences.join("\n"));
    assert!(
        first.len() > 40,
        "only {} options were compared",
        first.len()
    );
}

fn is_shared(option: &Arg) -> bool {
    option
        .get_long()
        .is_some_and(|long| !OWN_MEANING.contains(&long))
        && !option.is_hide_set()
}

#[test]
fn every_option_has_a_description() {
    for_each_command(&mut command(), &mut |command| {
        for option in command.get_arguments().filter(|arg| !arg.is_hide_set()) {
            assert!(
                option.get_help().is_some(),
                "{} of {} has no description",
                option.get_id(),
                command.get_name()
            );
        }
    });
}
