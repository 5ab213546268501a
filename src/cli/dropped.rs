//! Files that are dropped on the window of `effigy view`, opened with the options of its command
//! line.

use crate::source::{Source, check_joints, check_moves, how_it_follows};
use effigy_app::{
    dropped::{OpenFiles, OpenedFile},
    file_list::LoadedAvatar,
};
use effigy_core::avatar::{Avatar, Clip};
use effigy_formats::{
    assumption::Assumption,
    open::{self, OpenedClip},
    webavatar::ForeignAvatar,
};
use std::path::Path;

impl OpenFiles for Source {
    fn is_motion(&self, path: &Path) -> bool {
        open::is_motion(path)
    }

    fn avatar(&self, path: &Path) -> anyhow::Result<OpenedFile<LoadedAvatar>> {
        let source = self.for_avatar(path);
        let ForeignAvatar {
            avatar,
            assumptions,
        } = source.read(path)?;
        // The command line's motion may be for the avatar that it names alone.
        let clips = source.clips(&avatar).unwrap_or_else(|error| {
            tracing::warn!("{error:#}");
            vec![]
        });
        Ok(OpenedFile {
            content: LoadedAvatar::new(avatar, clips),
            notes: notes(path, &assumptions),
        })
    }

    fn clip(&self, path: &Path, avatar: &Avatar) -> anyhow::Result<OpenedFile<Clip>> {
        check_moves(avatar)?;
        let options = self.capture.clip_options(None)?;
        let OpenedClip {
            clip,
            assumptions,
            report,
            ..
        } = open::clip(path, avatar, &options)?;
        check_joints(&clip, avatar)?;
        let follows = report.map(|report| how_it_follows(path, &report));
        let notes = follows.into_iter().chain(notes(path, &assumptions));
        Ok(OpenedFile {
            content: clip,
            notes: notes.collect(),
        })
    }
}

/// What a file left open, each a line that names it.
fn notes(path: &Path, assumptions: &[Assumption]) -> Vec<String> {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    let note = |assumption| format!("{name}: {assumption}");
    assumptions.iter().map(note).collect()
}
