//! The subcommands in groups, as `effigy --help` lists them. clap has no groups of subcommands, so
//! the list is made here from clap's own names and descriptions.

use clap::Command;

/// A heading of the help page and the subcommands under it.
struct CommandGroup {
    title: &'static str,
    commands: &'static [&'static str],
}

const GROUPS: [CommandGroup; 4] = [
    CommandGroup {
        title: "Draw",
        commands: &["view", "render", "capture"],
    },
    CommandGroup {
        title: "Measure",
        commands: &["bench", "soak", "compare", "devices"],
    },
    CommandGroup {
        title: "Learn",
        commands: &["bake", "dataset", "train", "prune", "evaluate"],
    },
    CommandGroup {
        title: "Files",
        commands: &[
            "inspect",
            "import",
            "export",
            "convert",
            "pack",
            "export-ply",
        ],
    },
];

/// The help page of `effigy` itself as a template of clap's: its subcommands come from `command`.
pub fn help_template(command: &Command) -> String {
    let header = command.get_styles().get_header();
    let literal = command.get_styles().get_literal();
    let mut template = String::from("{before-help}{about-with-newline}\n{usage-heading} {usage}\n");
    for group in &GROUPS {
        template += &format!("\n{header}{}:{header:#}\n", group.title);
        for name in group.commands {
            let about = command
                .find_subcommand(name)
                .and_then(Command::get_about)
                .map(ToString::to_string)
                .unwrap_or_default();
            template += &format!("  {literal}{name:<12}{literal:#}  {about}\n");
        }
    }
    template += &format!("\n{header}Options:{header:#}\n{{options}}\n\n");
    template + "`effigy COMMAND --help` lists the options of a command.{after-help}"
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_subcommand_is_in_exactly_one_group() {
        let mut grouped: Vec<&str> = GROUPS
            .iter()
            .flat_map(|group| group.commands)
            .copied()
            .collect();
        let command = crate::command();
        let mut subcommands: Vec<&str> = command.get_subcommands().map(Command::get_name).collect();
        grouped.sort_unstable();
        subcommands.sort_unstable();
        assert_eq!(grouped, subcommands);
    }

    #[test]
    fn help_lists_the_groups_with_descriptions() {
        let help = crate::command().render_long_help().to_string();
        for group in &GROUPS {
            assert!(help.contains(&format!("\n{}:\n", group.title)), "{help}");
        }
        assert!(
            help.contains("  export-ply    Write an avatar in one pose"),
            "{help}"
        );
        assert!(help.contains("--verbose") && !help.contains("Commands:"));
        let widest = help.lines().map(|line| line.chars().count()).max();
        assert!(widest <= Some(100), "a line of {widest:?} characters");
    }
}
