//! What replaces commands and options that are gone: added to the error of who still writes one.

use clap::error::{ContextKind, ContextValue, Error};

/// A command or an option that is gone, or a value of one, and what there is instead.
struct Gone {
    written: &'static str,
    instead: &'static str,
}

/// What tells of `effigy-lab`.
const LAB: &str =
    "it is in the laboratory now: `cargo run --profile desktop -p effigy-lab -- --help`";

/// What replaces a share of the rows.
const ROWS: &str =
    "`effigy bench --sweep rows` measures shares of the rows; `effigy prune` removes rows";

const GONE: &[Gone] = &[
    Gone {
        written: "stress",
        instead: LAB,
    },
    Gone {
        written: "bench-sort",
        instead: LAB,
    },
    Gone {
        written: "bench-device",
        instead: LAB,
    },
    Gone {
        written: "verdict",
        instead: LAB,
    },
    Gone {
        written: "--shader-stats",
        instead: LAB,
    },
    Gone {
        written: "phone-model",
        instead: "its last tables are in docs/experiments/068-what-phones-would-take.md",
    },
    Gone {
        written: "fit",
        instead: "`effigy train` learns an avatar from pictures, which `effigy dataset` makes",
    },
    Gone {
        written: "analyse",
        instead: "`effigy train --set sizes.parts=1` and so on, then `effigy evaluate`: \
                  docs/experiments/054-from-pictures.md has the tables",
    },
    Gone {
        written: "--cpu",
        instead: "leave it out: CPU drivers draw as suits them, and nothing is timed on them",
    },
    Gone {
        written: "tiles",
        instead: "`--raster tiles-shared` is for desktop GPUs, `tiles-cooperative` for CPU drivers; \
                  each draws as suits it without --raster",
    },
    Gone {
        written: "tiles-per-thread",
        instead: "`--raster tiles-cooperative` is as fast or faster on every CPU driver",
    },
    Gone {
        written: "--strip",
        instead: "`effigy render --supersample 1` and `auto` draw an avatar both ways, and \
                  `--reference` as it should look",
    },
    Gone {
        written: "--pose-rate",
        instead: "`effigy bench --sweep pose-rate` measures every rate",
    },
    Gone {
        written: "--row-share",
        instead: ROWS,
    },
    Gone {
        written: "--rows",
        instead: ROWS,
    },
    Gone {
        written: "--warm-up",
        instead: "leave it out: frames are drawn for half a second, and at least three, before any is \
                  timed",
    },
    Gone {
        written: "--preset",
        instead: "the default draws as `high` did; `--exact` draws as `exact`; for `low` and `balanced` \
                  write `--cutoff 4 --detail auto` and `--cutoff 2`",
    },
    Gone {
        written: "--color",
        instead: "leave it out: quads store 16-bit floats, tiles 8 bits a channel, or floats with --exact",
    },
    Gone {
        written: "--keys",
        instead: "leave it out: depth keys have 22 bits, whose steps are under 1 µm for a person",
    },
    Gone {
        written: "--words",
        instead: "leave it out: f16 is read as words on every device, at the same speed",
    },
    Gone {
        written: "--workgroup",
        instead: "leave it out: workgroups have 64 invocations, whose size changed no time",
    },
];

/// Says in an error of the command line what replaces an option that is gone.
pub fn explained(mut error: Error) -> Error {
    let kinds = [
        ContextKind::InvalidSubcommand,
        ContextKind::InvalidValue,
        ContextKind::InvalidArg,
    ];
    let gone = kinds.into_iter().find_map(|kind| match error.get(kind) {
        Some(ContextValue::String(written)) => GONE.iter().find(|gone| gone.written == written),
        _ => None,
    });
    if let Some(gone) = gone {
        // What clap takes for similar is not what replaces it.
        error.remove(ContextKind::SuggestedSubcommand);
        error.remove(ContextKind::SuggestedArg);
        error.remove(ContextKind::SuggestedValue);
        let instead = ContextValue::StyledStrs(vec![gone.instead.into()]);
        error.insert(ContextKind::Suggested, instead);
    }
    error
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn options_that_are_gone_name_what_replaces_them() {
        for gone in GONE {
            let written = gone.written;
            let written = match written {
                "phone-model" | "fit" | "analyse" => written.to_owned(),
                _ if written.starts_with("--") => format!("bench {written}"),
                _ => format!("bench --raster {written}"),
            };
            let arguments = ["effigy"].into_iter().chain(written.split(' '));
            let error = crate::command()
                .try_get_matches_from(arguments)
                .unwrap_err();
            let text = explained(error).to_string();
            let words = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ");
            assert!(
                words(&text).contains(&words(gone.instead)),
                "{written}: {text}"
            );
        }
    }
}
