//! The program in a display of its own, driven as a person would: keys, mouse, and a window
//! manager's requests.
//!
//! Every wait has a limit, after which the test fails with what the program said.

use super::drag_source::DragSource;
use crate::common::{self, Sizes, harness::not_run};
use image::RgbImage;
use std::{
    fmt::Write,
    io::{BufRead, BufReader, Read},
    path::Path,
    process::{Child, Command, Stdio},
    sync::{Arc, Mutex},
    thread,
    time::{Duration, Instant},
};
use x11rb::{
    connection::Connection,
    protocol::{
        xproto::{self, ConfigureWindowAux, ConnectionExt as _, ImageFormat, Window},
        xtest::ConnectionExt as _,
    },
    rust_connection::RustConnection,
};

/// No wait takes longer: on a busy machine without a GPU a frame may take a second, and Mesa 22
/// compiles the kernels of a training for 140 s.
const LIMIT: Duration = Duration::from_secs(240);
/// Without a frame for so long, the viewer rests, seconds.
const REST: f64 = 0.6;

pub fn atom(x: &RustConnection, name: &str) -> u32 {
    let asked = x.intern_atom(false, name.as_bytes()).unwrap();
    asked.reply().unwrap().atom
}

/// What the program has said, line by line.
type Log = Arc<Mutex<Vec<String>>>;

pub struct Session {
    xvfb: Child,
    program: Child,
    x: RustConnection,
    root: Window,
    window: Window,
    log: Log,
    _folder: tempfile::TempDir,
}

impl Drop for Session {
    fn drop(&mut self) {
        for child in [&mut self.program, &mut self.xvfb] {
            let _ = child.kill();
            let _ = child.wait();
        }
    }
}

/// Starts an X server on a display number of its own choice.
fn xvfb() -> (Child, String) {
    let started = Command::new("Xvfb")
        .args([
            "-displayfd",
            "1",
            "-screen",
            "0",
            "1280x1024x24",
            "-nolisten",
            "tcp",
        ])
        .stdout(Stdio::piped())
        .stderr(Stdio::null())
        .spawn();
    let mut server =
        started.unwrap_or_else(|error| not_run(format!("Xvfb does not start: {error}")));
    let mut number = String::new();
    BufReader::new(server.stdout.take().unwrap())
        .read_line(&mut number)
        .unwrap();
    (server, format!(":{}", number.trim()))
}

fn follow(stream: impl Read + Send + 'static, log: &Log) {
    let log = log.clone();
    thread::spawn(move || {
        BufReader::new(stream)
            .lines()
            .map_while(Result::ok)
            .for_each(|line| log.lock().unwrap().push(line))
    });
}

/// A small avatar and two clips for it.
fn files(folder: &Path) {
    let avatar = common::avatar(1, Sizes::default());
    avatar.write(&folder.join("body.avatar")).unwrap();
    common::avatar(2, Sizes::default())
        .write(&folder.join("other.avatar"))
        .unwrap();
    for seed in [1, 2] {
        common::clip(seed, &avatar, 60)
            .write(&folder.join(format!("{seed}.motion")))
            .unwrap();
    }
}

impl Session {
    /// Starts `effigy view` with these arguments, and waits for its first frame.
    pub fn start(arguments: &[&str]) -> Self {
        let motion = ["--motion", "1.motion", "--motion", "2.motion"];
        Self::run(&[&["view", "body.avatar"], &motion[..], arguments].concat())
    }

    /// Starts `effigy` with these arguments, and waits for its window's first frame.
    pub fn run(arguments: &[&str]) -> Self {
        common::gpu::drawing();
        let (xvfb, display) = xvfb();
        let folder = tempfile::tempdir().unwrap();
        files(folder.path());
        let mut program = Command::new(common::program())
            .args(arguments)
            .current_dir(folder.path())
            .env("DISPLAY", &display)
            .env("RUST_LOG", "effigy=debug")
            .env_remove("WAYLAND_DISPLAY")
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        let log = Log::default();
        follow(program.stdout.take().unwrap(), &log);
        follow(program.stderr.take().unwrap(), &log);
        let (x, screen) = x11rb::connect(Some(&display)).unwrap();
        let root = x.setup().roots[screen].root;
        let mut session = Self {
            xvfb,
            program,
            x,
            root,
            window: 0,
            log,
            _folder: folder,
        };
        let kind = session
            .x
            .intern_atom(false, b"WM_CLASS")
            .unwrap()
            .reply()
            .unwrap()
            .atom;
        session.wait("the window", |s| {
            let of_viewer = |w: &Window| {
                s.x.get_property(false, *w, kind, xproto::AtomEnum::ANY, 0, 99)
                    .unwrap()
                    .reply()
                    .is_ok_and(|r| r.value_len > 0)
            };
            s.window =
                s.x.query_tree(s.root)
                    .unwrap()
                    .reply()
                    .unwrap()
                    .children
                    .into_iter()
                    .find(of_viewer)?;
            (s.frames() > 0 || s.program.try_wait().unwrap().is_some()).then_some(())
        });
        session
    }

    fn text(&self) -> String {
        self.log.lock().unwrap().join("\n")
    }

    fn wait<T>(&mut self, what: &str, mut done: impl FnMut(&mut Self) -> Option<T>) -> T {
        let start = Instant::now();
        loop {
            if let Some(value) = done(self) {
                return value;
            }
            assert!(
                start.elapsed() < LIMIT,
                "{what} did not come within {LIMIT:?}; the program said:\n{}",
                self.text()
            );
            thread::sleep(Duration::from_millis(20));
        }
    }

    /// Frames drawn so far.
    pub fn frames(&self) -> usize {
        self.log
            .lock()
            .unwrap()
            .iter()
            .filter(|line| line.contains("frame "))
            .count()
    }

    pub fn wait_for_frames(&mut self, more: usize) {
        let wanted = self.frames() + more;
        self.wait("a frame", |s| (s.frames() >= wanted).then_some(()));
    }

    /// Waits until more frames than `drawn` have been drawn.
    pub fn wait_for_frames_after(&mut self, drawn: usize) {
        self.wait("a frame", |s| (s.frames() > drawn).then_some(()));
    }

    /// Waits until no frame has been drawn for a while.
    pub fn wait_for_rest(&mut self) {
        self.sleep(0.3);
        let mut last = (self.frames(), Instant::now());
        self.wait("a rest", |s| {
            if s.frames() != last.0 {
                last = (s.frames(), Instant::now());
            }
            (last.1.elapsed().as_secs_f64() > REST).then_some(())
        });
    }

    /// Waits until the window shows another image.
    pub fn wait_for_other_image(&mut self, before: &RgbImage) {
        self.wait("another image", |s| {
            (s.read_image() != *before).then_some(())
        });
    }

    /// Waits for a frame of a size.
    pub fn wait_for_size(&mut self, [width, height]: [u32; 2]) {
        let ending = format!(", {width} × {height}");
        let last = |s: &Self| {
            s.log
                .lock()
                .unwrap()
                .iter()
                .rfind(|line| line.contains("frame "))
                .cloned()
        };
        self.wait(&format!("a frame of {width} × {height} px"), |s| {
            last(s).filter(|line| line.ends_with(&ending)).map(drop)
        });
    }

    /// Waits for a line that begins so, and returns its rest.
    pub fn wait_for_line(&mut self, start: &str) -> String {
        let found = |s: &mut Self| {
            s.log
                .lock()
                .unwrap()
                .iter()
                .find_map(|line| line.strip_prefix(start).map(String::from))
        };
        let path = self.wait(start, found);
        self._folder
            .path()
            .join(path)
            .to_string_lossy()
            .into_owned()
    }

    /// Waits until the program has said something.
    pub fn wait_for_text(&mut self, text: &str) {
        self.wait(text, |s| {
            s.log
                .lock()
                .unwrap()
                .iter()
                .any(|line| line.contains(text))
                .then_some(())
        });
    }

    /// Waits until the program has ended, and gives the text of a file that it wrote.
    pub fn wait_for_file(&mut self, name: &str) -> String {
        self.wait(name, |s| s.program.try_wait().unwrap().map(|_| ()));
        std::fs::read_to_string(self._folder.path().join(name)).unwrap()
    }

    pub fn sleep(&self, seconds: f64) {
        thread::sleep(Duration::from_secs_f64(seconds));
    }

    fn fake(&self, kind: u8, detail: u8, [x, y]: [i16; 2]) {
        self.x
            .xtest_fake_input(kind, detail, 0, self.root, x, y, 0)
            .unwrap();
        self.x.flush().unwrap();
    }

    /// Presses and releases a key, by the character on it.
    pub fn key(&self, character: char) {
        self.x
            .set_input_focus(xproto::InputFocus::PARENT, self.window, x11rb::CURRENT_TIME)
            .unwrap();
        let (first, last) = (self.x.setup().min_keycode, self.x.setup().max_keycode);
        let map = self
            .x
            .get_keyboard_mapping(first, last - first + 1)
            .unwrap()
            .reply()
            .unwrap();
        let columns = usize::from(map.keysyms_per_keycode);
        let at = map
            .keysyms
            .chunks(columns)
            .position(|keysyms| keysyms.first() == Some(&u32::from(character)));
        let code =
            first + at.unwrap_or_else(|| panic!("the keyboard has no key {character:?}")) as u8;
        self.fake(xproto::KEY_PRESS_EVENT, code, [0, 0]);
        self.fake(xproto::KEY_RELEASE_EVENT, code, [0, 0]);
    }

    pub fn move_mouse(&self, to: [i16; 2]) {
        self.fake(xproto::MOTION_NOTIFY_EVENT, 0, to);
    }

    /// Drags with the left button.
    pub fn drag(&self, from: [i16; 2], to: [i16; 2]) {
        self.move_mouse(from);
        self.sleep(0.1);
        self.fake(xproto::BUTTON_PRESS_EVENT, 1, [0, 0]);
        for step in 1..=10 {
            self.move_mouse([0, 1].map(|k| from[k] + (to[k] - from[k]) * step / 10));
            self.sleep(0.02);
        }
        self.fake(xproto::BUTTON_RELEASE_EVENT, 1, [0, 0]);
    }

    /// Clicks with the left button.
    pub fn click(&self, at: [i16; 2]) {
        self.drag(at, at);
    }

    /// Whether the program has said a text by now.
    pub fn has_said(&self, text: &str) -> bool {
        let log = self.log.lock().unwrap();
        log.iter().any(|line| line.contains(text))
    }

    /// Turns the wheel up.
    pub fn wheel(&self, notches: u32) {
        for _ in 0..notches {
            self.fake(xproto::BUTTON_PRESS_EVENT, 4, [0, 0]);
            self.fake(xproto::BUTTON_RELEASE_EVENT, 4, [0, 0]);
        }
    }

    pub fn resize(&self, [width, height]: [u32; 2]) {
        self.x
            .configure_window(
                self.window,
                &ConfigureWindowAux::new().width(width).height(height),
            )
            .unwrap();
        self.x.flush().unwrap();
    }

    /// Shows the window or takes it off the screen.
    pub fn map(&self, shown: bool) {
        if shown {
            self.x.map_window(self.window).unwrap()
        } else {
            self.x.unmap_window(self.window).unwrap()
        };
        self.x.flush().unwrap();
    }

    pub fn destroy(&self) {
        self.x.destroy_window(self.window).unwrap();
        self.x.flush().unwrap();
    }

    /// Drops files of the session's folder on the window, as a file manager does.
    pub fn drop_files(&mut self, names: &[&str]) {
        let folder = self._folder.path();
        let uri = |name: &&str| format!("file://{}\r\n", folder.join(name).display());
        let list: String = names.iter().map(uri).collect();
        DragSource::new(&self.x, self.root, self.window).drop_list(&list);
    }

    /// Writes a file into the session's folder.
    pub fn write_file(&self, name: &str, bytes: &[u8]) {
        std::fs::write(self._folder.path().join(name), bytes).unwrap();
    }

    /// The window's title.
    pub fn title(&self) -> String {
        let name = atom(&self.x, "_NET_WM_NAME");
        let kind = xproto::AtomEnum::ANY;
        let title = self.x.get_property(false, self.window, name, kind, 0, 99);
        String::from_utf8(title.unwrap().reply().unwrap().value).unwrap()
    }

    pub fn wait_for_title(&mut self, title: &str) {
        self.wait(title, |s| (s.title() == title).then_some(()));
    }

    /// What the window shows.
    pub fn read_image(&self) -> RgbImage {
        let size = self.x.get_geometry(self.window).unwrap().reply().unwrap();
        let (width, height) = (size.width, size.height);
        let image = self
            .x
            .get_image(
                ImageFormat::Z_PIXMAP,
                self.window,
                0,
                0,
                width,
                height,
                u32::MAX,
            )
            .unwrap()
            .reply()
            .unwrap();
        let pixels = image
            .data
            .chunks_exact(4)
            .flat_map(|bgrx| [bgrx[2], bgrx[1], bgrx[0]])
            .collect();
        RgbImage::from_raw(width.into(), height.into(), pixels).unwrap()
    }

    /// Quits with the key, and checks how the program ended.
    pub fn quit(self) {
        self.key('q');
        let (success, text) = self.wait_for_end();
        assert!(success, "{text}");
    }

    /// Asks the program to end, as systems do.
    pub fn terminate(&self) {
        let id = self.program.id().to_string();
        Command::new("kill").arg(id).status().unwrap();
    }

    /// Waits for the program's end: whether it succeeded, and all it said. No validation message
    /// may be among it.
    pub fn wait_for_end(mut self) -> (bool, String) {
        let status = self.wait("the program's end", |s| s.program.try_wait().unwrap());
        self.sleep(0.1);
        let mut text = self.text();
        assert!(
            !text.contains("validation:") && !text.contains("panicked"),
            "{text}"
        );
        write!(text, "\n{status}").unwrap();
        (status.success(), text)
    }
}

/// Runs the program where there is no display: whether it succeeded, and all it said.
pub fn without_display(arguments: &[&str]) -> (bool, String) {
    let folder = tempfile::tempdir().unwrap();
    let mut command = Command::new(common::program());
    command.args(arguments).current_dir(folder.path());
    ["DISPLAY", "WAYLAND_DISPLAY", "WAYLAND_SOCKET"]
        .iter()
        .for_each(|variable| {
            command.env_remove(variable);
        });
    let output = command.output().unwrap();
    let text = [output.stdout, output.stderr]
        .map(|text| String::from_utf8_lossy(&text).into_owned())
        .join("\n");
    (output.status.success(), text)
}

/// Pixels that are not of the background's colour.
pub fn covered(image: &RgbImage, background: [u8; 3]) -> u32 {
    image
        .pixels()
        .filter(|pixel| {
            pixel
                .0
                .iter()
                .zip(background)
                .any(|(a, b)| a.abs_diff(b) > 8)
        })
        .count() as u32
}
