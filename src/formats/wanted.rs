//! Which file of a zip is read.

use crate::{assumption::Assumption, splats, zip_file::Member};
use effigy_core::io::file::{FormatError, excerpt};
use std::{
    ffi::{OsStr, OsString},
    path::Path,
};

/// Files that a sentence names, at most.
const NAMED: usize = 6;
/// Endings of files that are read.
const READ: [&str; 20] = [
    "ply", "splat", "spz", "sog", "ksplat", "glb", "gltf", "vrm", "vrma", "bvh", "fbx", "npz",
    "npy", "pkl", "pt", "pth", "avatar", "motion", "gz", "zip",
];

/// What is looked for in a zip.
#[derive(Clone, Copy)]
pub enum Wanted {
    /// Splats, motion or an avatar.
    Content,
    /// Cameras of another program.
    #[cfg(not(target_arch = "wasm32"))]
    Cameras,
}

/// A file of a zip.
pub struct Chosen<'a> {
    pub member: &'a Member,
    /// Why this one, where others could be meant.
    pub why: Option<Assumption>,
}

impl Wanted {
    /// Whether a reader takes a zip of these files whole.
    pub fn is_whole(self, members: &[Member]) -> bool {
        let is_read = |member: &Member| {
            let folder = member.name.split_once('/');
            member.name.ends_with(".npy") || folder.is_some_and(|(_, name)| name == "data.pkl")
        };
        match self {
            Self::Content => splats::is_sog(members) || members.iter().any(is_read),
            #[cfg(not(target_arch = "wasm32"))]
            Self::Cameras => false,
        }
    }

    /// Whether a file of this name, with its folders, may be it.
    fn is(self, name: &str) -> bool {
        let ending = ending(name).unwrap_or_default();
        match self {
            Self::Content => READ.contains(&&*ending),
            #[cfg(not(target_arch = "wasm32"))]
            Self::Cameras => {
                let own = name.rsplit('/').next();
                ["json", "gz", "zip"].contains(&&*ending) || own == Some("images.txt")
            }
        }
    }

    /// What a zip without it should have.
    fn expected(self, members: &[Member]) -> &'static str {
        let is_usd = |member: &Member| {
            ending(&member.name).is_some_and(|it| ["usd", "usda", "usdc"].contains(&&*it))
        };
        match self {
            Self::Content if members.iter().any(is_usd) => {
                "another format than USD: convert it to .ply or glTF"
            }
            Self::Content => "a file in it that is read: splats, motion or an avatar",
            #[cfg(not(target_arch = "wasm32"))]
            Self::Cameras => "cameras.json, transforms.json or COLMAP's text files in it",
        }
    }

    /// The only file of a zip that it may be, or of several `.ply` that of the highest iteration.
    ///
    /// # Errors
    /// When there is none, or several. The error lists what the zip has.
    pub fn of(self, members: &[Member]) -> Result<Chosen<'_>, FormatError> {
        let of_it = || members.iter().filter(|member| self.is(&member.name));
        if let (Some(member), None) = (of_it().next(), of_it().nth(1)) {
            return Ok(Chosen { member, why: None });
        }
        let is_ply = |member: &Member| ending(&member.name).is_some_and(|it| it == "ply");
        if of_it().all(is_ply)
            && let Some(member) = latest(of_it())
        {
            let why = Some(Assumption {
                what: "file of the zip",
                taken: format!("`{}`", excerpt(&member.name)),
                because: format!(
                    "of its {} .ply it has the highest iteration",
                    of_it().count()
                ),
            });
            return Ok(Chosen { member, why });
        }
        let expected = match of_it().next() {
            Some(_) => "one file that is read: unpack the zip and open one of them",
            None => self.expected(members),
        };
        let found = format!("a zip of {}", self.listed(members));
        Err(FormatError::container(found, expected))
    }

    /// What a file of a zip is called: an avatar or a clip as the zip is.
    pub fn called(self, member: &Member, zip: &Path) -> OsString {
        match self {
            Self::Content => {
                let mut name = zip.file_stem().unwrap_or_default().to_owned();
                name.push(".");
                name.push(ending(&member.name).unwrap_or_default());
                name
            }
            #[cfg(not(target_arch = "wasm32"))]
            Self::Cameras => member.name.clone().into(),
        }
    }

    /// The names of a zip's files, those that could be meant first.
    fn listed(self, members: &[Member]) -> String {
        let mut named: Vec<&Member> = members.iter().collect();
        named.sort_by_key(|member| !self.is(&member.name));
        let name = |member: &&Member| format!("`{}`", excerpt(&member.name));
        let mut names: Vec<String> = named.iter().take(NAMED).map(name).collect();
        if named.len() > NAMED {
            names.push(format!("{} more", named.len() - NAMED));
        }
        if names.is_empty() {
            return "nothing".into();
        }
        names.join(", ")
    }
}

/// The ending of a name, in small letters.
fn ending(name: &str) -> Option<String> {
    let ending = Path::new(name).extension().and_then(OsStr::to_str)?;
    Some(ending.to_ascii_lowercase())
}

/// The only file of the highest iteration, among those that name one.
fn latest<'a>(members: impl Iterator<Item = &'a Member>) -> Option<&'a Member> {
    let mut named: Vec<(u64, &Member)> = members
        .filter_map(|member| Some((iteration(&member.name)?, member)))
        .collect();
    named.sort_by_key(|(iteration, _)| *iteration);
    match named[..] {
        [.., (before, _), (last, _)] if before == last => None,
        [.., (_, member)] => Some(member),
        [] => None,
    }
}

/// The iteration of training that a name says, as 3DGS does: `point_cloud/iteration_7000/…`.
fn iteration(name: &str) -> Option<u64> {
    let (_, rest) = name.rsplit_once("iteration_")?;
    let end = rest.find(|c: char| !c.is_ascii_digit());
    rest[..end.unwrap_or(rest.len())].parse().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn chosen(names: &[&str]) -> Option<String> {
        let member = |(index, name): (usize, &&str)| Member {
            index,
            name: (*name).into(),
        };
        let members: Vec<Member> = names.iter().enumerate().map(member).collect();
        let chosen = Wanted::Content.of(&members).ok()?;
        assert_eq!(
            chosen.why.is_some(),
            names.iter().filter(|name| Wanted::Content.is(name)).count() > 1
        );
        Some(chosen.member.name.clone())
    }

    #[test]
    fn of_several_plys_the_highest_iteration_is_taken() {
        let last = "out/point_cloud/iteration_30000/point_cloud.ply";
        let first = "out/point_cloud/iteration_7000/point_cloud.ply";
        for names in [
            vec!["out/cfg_args", last],
            vec!["out/input.ply", first, last, "out/cameras.json"],
            vec![last, first],
            vec!["input.PLY", last],
            vec!["iteration_9/a.ply", "iteration_10/a.ply", last],
        ] {
            assert_eq!(chosen(&names).as_deref(), Some(last), "{names:?}");
        }
        assert_eq!(
            chosen(&["a_iteration_5.ply", "a_iteration_40.ply"]).as_deref(),
            Some("a_iteration_40.ply")
        );
        for names in [
            vec!["7000/a.ply", "30000/a.ply"],
            // Two of the highest, motion beside splats, and a number that is none.
            vec![
                "iteration_9/a.ply",
                "iteration_9/b.ply",
                "iteration_8/a.ply",
            ],
            vec!["iteration_9/a.ply", "iteration_8/a.ply", "walk.bvh"],
            vec!["iteration_last/a.ply", "input.ply"],
            vec!["iteration_99999999999999999999/a.ply", "input.ply"],
        ] {
            assert_eq!(chosen(&names), None, "{names:?}");
        }
    }
}
