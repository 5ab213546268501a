//! Files of other programs, and the bytes of Effigy's own that they become.

use crate::body::SkinnedBody;
use effigy_core::io::{
    file::FormatError,
    splats::{Up, to_columns},
};
use effigy_formats::{
    assumption::Assumption,
    content::Content,
    read::{self, ClipOptions, OpenOptions, Source},
    source,
    splats::Nothing,
};
use std::path::Path;

/// An avatar of another program.
pub struct ImportedAvatar {
    /// Of an `.avatar` file, or of splats as [`to_columns`] writes them.
    pub bytes: Vec<u8>,
    /// Whether they are splats, which no `.avatar` file holds.
    pub is_splats: bool,
    /// What the file left open, a line each.
    pub notes: Vec<String>,
}

/// Motion of another program.
pub struct ImportedMotion {
    /// Of a `.motion` file.
    pub bytes: Vec<u8>,
    /// What the file left open, a line each.
    pub notes: Vec<String>,
}

/// What a file of another program is: "avatar", "motion" or "unknown". `name`: the file's.
pub fn kind(bytes: &[u8], name: &str) -> &'static str {
    let content = Content::of(bytes, Path::new(name));
    // Reading a checkpoint says what becomes an avatar of it, and reading an archive what it has.
    let is_said = content == Content::Checkpoint || source::is_packed(bytes);
    if content.is_avatar() || is_said && !content.is_motion() {
        "avatar"
    } else if content.is_motion() {
        "motion"
    } else {
        "unknown"
    }
}

/// Reads an avatar of another program. `name`: the file's, whose stem names the avatar.
///
/// # Errors
/// When the file is of no known kind, refers to files beside it, or breaks a rule.
pub fn avatar(bytes: &[u8], name: &str) -> Result<ImportedAvatar, FormatError> {
    let mut beside = Nothing;
    let source = source(bytes, name, &mut beside);
    if source.content().is_motion() {
        return Err(FormatError::container("motion", "an avatar"));
    }
    let imported = read::avatar(source, &OpenOptions::default())?;
    let avatar = imported.avatar;
    let is_splats = avatar.is_static();
    Ok(ImportedAvatar {
        bytes: if is_splats {
            to_columns(&avatar)
        } else {
            avatar.to_bytes()?
        },
        is_splats,
        notes: notes(&imported.assumptions),
    })
}

/// Reads motion of another program for an avatar. `name`: the file's, whose stem names the clip.
///
/// # Errors
/// When the file is of no known kind, refers to files beside it or breaks a rule, or when there is
/// no body in it or in the avatar.
pub fn motion(bytes: &[u8], name: &str, body: &SkinnedBody) -> Result<ImportedMotion, FormatError> {
    let mut beside = Nothing;
    let source = source(bytes, name, &mut beside);
    if source.content().is_avatar() {
        return Err(FormatError::container("an avatar", "motion"));
    }
    let opened = read::clip(
        source,
        &body.skeleton,
        || body.girth(),
        &ClipOptions::default(),
    )?;
    Ok(ImportedMotion {
        bytes: opened.clip.to_bytes()?,
        notes: notes(&opened.assumptions),
    })
}

fn source<'a>(bytes: &'a [u8], name: &'a str, beside: &'a mut Nothing) -> Source<'a> {
    Source::new(bytes, Path::new(name), beside)
}

fn notes(assumptions: &[Assumption]) -> Vec<String> {
    // A page has no option that would answer it, and would ask with every scan.
    let said = assumptions.iter().filter(|own| own.what != Up::QUESTION);
    said.map(Assumption::to_string).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use effigy_core::{
        avatar::{Avatar, Clip},
        io::splats::from_columns,
    };
    use effigy_formats::open;

    fn path(name: &str) -> String {
        format!("{}/../../tests/data/{name}", env!("CARGO_MANIFEST_DIR"))
    }

    fn read(name: &str) -> Vec<u8> {
        std::fs::read(path(name)).expect("a file of the repository")
    }

    /// The demo, as the main library writes it.
    fn demo() -> SkinnedBody {
        let avatar = effigy_demo::avatar().expect("inside the program");
        let skeleton = &avatar.skeleton;
        let gaussians = &avatar.gaussians;
        let document = serde_json::json!({
            "joints": skeleton.name,
            "parents": skeleton.parent,
            "rest": skeleton.rest,
            "canonical": skeleton.canonical,
            "bounds": [gaussians.bounds.min, gaussians.bounds.max],
        });
        let mut skin = vec![];
        for at in 0..gaussians.len() {
            skin.extend(bytemuck::bytes_of(&gaussians.position[at]));
            skin.extend(gaussians.joint[at]);
            skin.extend(gaussians.joint_weight[at]);
        }
        SkinnedBody::new(&document.to_string(), &skin).expect("a body")
    }

    #[test]
    fn avatars_are_those_of_their_files() {
        for name in [
            "webavatar/small.npz",
            "splats/small-4.spz",
            "splats/truth.ply",
            "splats/small.sog",
            "splats/small.glb",
        ] {
            let bytes = read(name);
            assert_eq!(kind(&bytes, name), "avatar", "{name}");
            let imported = avatar(&bytes, name).expect(name);
            let opened = open::avatar(path(name).as_ref(), &OpenOptions::default());
            let expected = opened.expect(name);
            let read = if imported.is_splats {
                from_columns(&imported.bytes)
            } else {
                Avatar::from_bytes(&imported.bytes)
            };
            assert_eq!(read, Ok(expected.avatar), "{name}");
            assert_eq!(imported.notes, notes(&expected.assumptions), "{name}");
        }
        assert!(avatar(&read("splats/truth.ply"), "a").is_ok_and(|own| own.notes.is_empty()));
    }

    #[test]
    fn motion_is_that_of_the_command_line() {
        let avatar = effigy_demo::avatar().expect("inside the program");
        let body = demo();
        for name in ["motion/mixamo.bvh", "motion/lafan.bvh", "smpl/aist_5.pkl"] {
            let bytes = read(name);
            assert_eq!(kind(&bytes, name), "motion", "{name}");
            let imported = motion(&bytes, name, &body).expect(name);
            let opened = open::clip(path(name).as_ref(), &avatar, &ClipOptions::default());
            let expected = opened.expect(name).clip;
            assert_eq!(Clip::from_bytes(&imported.bytes), Ok(expected), "{name}");
        }
    }

    #[test]
    fn splats_that_cannot_be_drawn_are_left_out_and_said_to_be() {
        let mut bytes = read("splats/small.splat");
        bytes[32 * 5..][..4].copy_from_slice(&f32::NAN.to_le_bytes());
        let imported = avatar(&bytes, "a.splat").expect("63 splats");
        let avatar = from_columns(&imported.bytes).expect("an avatar");
        assert_eq!(avatar.gaussians.len(), 63);
        assert!(imported.notes[0].contains("1 of 64 left out"));
    }

    #[test]
    fn other_files_are_refused_in_a_sentence() {
        assert_eq!(kind(b"nothing of ours", "a.avatar"), "unknown");
        // What an archive has is said when it is read.
        assert_eq!(kind(b"PK\x03\x04", "a.zip"), "avatar");
        assert!(avatar(b"nothing of ours", "a.avatar").is_err());
        assert!(avatar(b"ply\nno header", "a.ply").is_err());
        let beside = motion(&read("gltf/dance_beside.gltf"), "dance.gltf", &demo());
        assert!(beside.is_err_and(|error| error.to_string().contains("beside")));
        assert!(motion(b"HIERARCHY\nROOT", "a.bvh", &demo()).is_err());
        let swapped = [
            avatar(b"HIERARCHY\nROOT", "a.bvh").err(),
            motion(&read("splats/truth.ply"), "a.ply", &demo()).err(),
        ];
        let sentences = swapped.map(|error| error.map(|error| error.to_string()));
        assert!(
            sentences
                .iter()
                .flatten()
                .all(|text| text.contains("motion"))
        );
        let fbx = motion(b"Kaydara FBX Binary", "a.fbx", &demo());
        assert!(fbx.is_err_and(|error| error.to_string().contains("FBX")));
    }
}
