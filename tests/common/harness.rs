//! Runs the tests of a group and reports them as `cargo test` does.
//!
//! The process that was started only reports. The tests run in worker processes, one for each test
//! thread, one test at a time, so that a worker opens its device once, a crash or a hang costs one
//! test, and whatever a validation layer says belongs to the test that ran.
//!
//! - `EFFIGY_TEST_SECONDS`: a worker is killed when a test takes longer (default 300), one of
//!   `tests/slow.txt` three times as long.
//! - `EFFIGY_NO_GPU=1`: leave out tests that need a Vulkan device; otherwise they fail without one.
//! - `EFFIGY_TEST_ONLY`: `device` or `no-device` tests only, `quick` ones (of no-device, what is
//!   not in `tests/slow.txt`), or `smoke` tests.
//! - `EFFIGY_TEST_RESULTS`: a file to which each test adds a line: outcome, seconds, label, name.
//! - `EFFIGY_TEST_LABEL`: the label of those lines, such as the driver's name.
//! - `EFFIGY_ENFORCE_TIMES=1`: a test over 20 s that is not in `tests/slow.txt` fails.

use super::gpu;
use effigy_render::vulkan::instance::validation_messages;
use libtest_mimic::{Arguments, Completion, Failed, Trial};
use std::{
    env,
    fs::{File, OpenOptions},
    io::{BufRead, BufReader, Read, Seek, SeekFrom, Write},
    net::{TcpListener, TcpStream},
    panic,
    path::Path,
    process::{Child, Command, ExitCode, ExitStatus, Stdio},
    sync::{Arc, Mutex, MutexGuard, PoisonError},
    thread,
    time::{Duration, Instant},
};

/// What tests of `tests/slow.txt` may take, of the time after which another is taken to hang.
const SLOW_TIMES: u64 = 3;
/// Tests may take this long, in seconds, unless they are listed in `tests/slow.txt`.
const SLOW: f64 = 20.0;
/// A worker that starts or ends may take this long.
const PATIENCE: Duration = Duration::from_secs(60);
/// Names the port of the reporting process; set in workers only.
const PORT: &str = "EFFIGY_TEST_PORT";
/// Asks a worker to open its device, and to end.
const OPEN: &str = "open a device";
const END: &str = "end";

/// A test and how it has to be run.
#[derive(Clone, Copy)]
pub struct Test {
    name: &'static str,
    run: fn(),
    smoke: bool,
    own_process: bool,
    no_device: bool,
}

impl Test {
    pub const fn new(name: &'static str, run: fn()) -> Self {
        Self {
            name,
            run,
            smoke: false,
            own_process: false,
            no_device: false,
        }
    }

    /// One of the few that `tools/check.sh quick` runs on a device.
    pub const fn smoke(mut self) -> Self {
        self.smoke = true;
        self
    }

    /// Changes or measures something that belongs to the whole process.
    pub const fn own_process(mut self) -> Self {
        self.own_process = true;
        self
    }

    /// Needs no Vulkan device, in a group whose tests do.
    pub const fn no_device(mut self) -> Self {
        self.no_device = true;
        self
    }
}

/// Lists the tests of a module: `tests! { name, other: smoke, third: own_process & smoke }`.
/// `name[Tiles]` calls `name(Tiles)`: a test for each of several values.
macro_rules! tests {
    ($($(#[$attribute:meta])* $name:ident $([$value:ident])? $(: $($flag:ident)&+)?),+ $(,)?) => {
        pub const TESTS: &[$crate::common::harness::Test] = &[$(
            $(#[$attribute])*
            tests!(@one $name $($value)?)$($(.$flag())+)?
        ),+];
    };
    (@one $name:ident) => {
        $crate::common::harness::Test::new(stringify!($name), $name)
    };
    (@one $name:ident $value:ident) => {
        $crate::common::harness::Test::new(
            concat!(stringify!($name), "::", stringify!($value)),
            || $name($value),
        )
    };
}

/// Lists the modules of a group.
macro_rules! modules {
    ($($(#[$attribute:meta])* $($segment:ident)::+),+ $(,)?) => {
        &[$($(#[$attribute])* (stringify!($($segment)::+), $($segment::)+TESTS)),+]
    };
}

/// A module's path in its group, and its tests.
pub type Module = (&'static str, &'static [Test]);

/// Why a test could not run.
struct NotRun(String);

/// Ends a test that this device or machine cannot run: it is reported as ignored.
pub fn not_run(reason: impl Into<String>) -> ! {
    panic::resume_unwind(Box::new(NotRun(reason.into())))
}

/// Which tests a group has.
#[derive(Clone, Copy, PartialEq)]
pub enum Group {
    /// None needs a device.
    Host,
    /// All need a device that aren't marked `no_device`.
    Device,
}

struct Selected {
    name: String,
    test: Test,
}

/// All tests of a group by their whole names.
fn all(modules: &[Module], group: Group) -> Vec<Selected> {
    let mut found = vec![];
    for (module, tests) in modules {
        let module = module.replace(' ', "");
        for &test in *tests {
            found.push(Selected {
                name: format!("{module}::{}", test.name),
                test: Test {
                    no_device: test.no_device || group == Group::Host,
                    ..test
                },
            });
        }
    }
    found
}

/// Runs the tests that the command line and the environment name. `name` is the test binary's.
pub fn main(name: &str, group: Group, modules: &[Module]) -> ExitCode {
    let mut tests = all(modules, group);
    if let Ok(port) = env::var(PORT) {
        work(&port, &tests);
        return ExitCode::SUCCESS;
    }
    let arguments = Arguments::from_args();
    let slow = slow(name, &tests);
    if let Ok(only) = env::var("EFFIGY_TEST_ONLY") {
        tests.retain(|selected| match only.as_str() {
            "device" => !selected.test.no_device,
            "no-device" => selected.test.no_device,
            "quick" => selected.test.no_device && !slow.contains(&selected.name),
            "smoke" => selected.test.smoke,
            _ => panic!("EFFIGY_TEST_ONLY is {only}: use device, no-device, quick or smoke"),
        });
    }
    // The longest first, so that none of them is alone at the end.
    tests.sort_by_key(|selected| !slow.contains(&selected.name));
    let context = Arc::new(Context {
        group: name.into(),
        idle: Mutex::default(),
        seconds: number("EFFIGY_TEST_SECONDS", 300),
        no_gpu: is_set("EFFIGY_NO_GPU"),
        enforce_times: is_set("EFFIGY_ENFORCE_TIMES"),
        print: arguments.nocapture,
        slow,
    });
    let mut device = false;
    let mut trials = vec![];
    for selected in tests {
        let (context, no_device) = (context.clone(), selected.test.no_device);
        let trial = Trial::ignorable_test(selected.name.clone(), move || context.run(&selected));
        device |= !no_device && !arguments.is_filtered_out(&trial);
        trials.push(trial);
    }
    if device
        && !arguments.list
        && !context.no_gpu
        && let Err(problem) = context.open_device()
    {
        eprintln!(
            "error: {problem}; `tools/test.sh` installs drivers, and EFFIGY_NO_GPU=1 leaves these \
             tests out"
        );
        return ExitCode::FAILURE;
    }
    let conclusion = libtest_mimic::run(&arguments, trials);
    let mut code = conclusion.exit_code();
    for worker in lock(&context.idle).drain(..) {
        if let Err(problem) = worker.end() {
            eprintln!("error: after the last test {problem}");
            context.record("FAILED", 0.0, "the_workers_end", "");
            code = ExitCode::FAILURE;
        }
    }
    code
}

fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

fn is_set(variable: &str) -> bool {
    env::var_os(variable).is_some_and(|value| value != "0")
}

fn number(variable: &str, default: u64) -> u64 {
    env::var(variable).map_or(default, |value| {
        value
            .parse()
            .unwrap_or_else(|_| panic!("{variable} is {value}, expected a whole number"))
    })
}

/// The tests of a group that `tests/slow.txt` allows to take long.
fn slow(group: &str, tests: &[Selected]) -> Vec<String> {
    let mut slow = vec![];
    for line in include_str!("../slow.txt").lines() {
        if line.is_empty() || line.starts_with('#') {
            continue;
        }
        let (name, reason) = line.split_once(' ').unwrap_or((line, ""));
        assert!(!reason.trim().is_empty(), "slow.txt: {name} has no reason");
        if let Some(name) = name.strip_prefix(&format!("{group}::")) {
            if !tests.iter().any(|selected| selected.name == name) {
                // Tests of features that are off are not there.
                eprintln!("warning: slow.txt names {name}, which is not in this build");
            }
            slow.push(name.to_owned());
        }
    }
    slow
}

/// What all test threads of the reporting process share.
struct Context {
    group: String,
    idle: Mutex<Vec<Worker>>,
    seconds: u64,
    no_gpu: bool,
    enforce_times: bool,
    print: bool,
    slow: Vec<String>,
}

impl Context {
    /// A worker that waits for a test, or a new one.
    fn worker(&self) -> Result<Worker, String> {
        let waiting = lock(&self.idle).pop();
        waiting.map_or_else(Worker::start, Ok)
    }

    /// Whether workers find a device.
    fn open_device(&self) -> Result<(), String> {
        let mut worker = self.worker()?;
        match worker.ask(OPEN, Duration::from_secs(self.seconds))? {
            Answer::Passed => {
                lock(&self.idle).push(worker);
                Ok(())
            }
            Answer::Failed(problem) | Answer::NotRun(problem) => Err(problem),
        }
    }

    fn run(&self, selected: &Selected) -> Result<Completion, Failed> {
        if self.no_gpu && !selected.test.no_device {
            let reason = "EFFIGY_NO_GPU is set";
            self.record("ignored", 0.0, &selected.name, reason);
            return Ok(Completion::ignored_with(reason));
        }
        let begin = Instant::now();
        let answer = self.answer(selected);
        let seconds = begin.elapsed().as_secs_f64();
        let answer = answer.and_then(|answer| self.in_time(selected, seconds, answer));
        match answer {
            Ok(Answer::Passed) => {
                self.record("ok", seconds, &selected.name, "");
                Ok(Completion::Completed)
            }
            Ok(Answer::NotRun(reason)) => {
                self.record("ignored", seconds, &selected.name, &reason);
                Ok(Completion::ignored_with(reason))
            }
            Ok(Answer::Failed(problem)) | Err(problem) => {
                self.record("FAILED", seconds, &selected.name, "");
                Err(problem.into())
            }
        }
    }

    /// Runs a test in a worker. An error is what became of the worker.
    fn answer(&self, selected: &Selected) -> Result<Answer, String> {
        let alone = selected.test.own_process;
        let mut worker = if alone {
            Worker::start()?
        } else {
            self.worker()?
        };
        // They begin first, when everything else that starts up begins too.
        let times = if self.slow.contains(&selected.name) {
            SLOW_TIMES
        } else {
            1
        };
        let limit = Duration::from_secs(times * self.seconds);
        let answer = worker.ask(&selected.name, limit)?;
        if self.print {
            eprint!("{}", worker.said());
        }
        if let Answer::Failed(problem) = answer {
            // What a failure leaves behind is not for the next test.
            return Ok(Answer::Failed(format!("{problem}{}", worker.said())));
        }
        if alone {
            worker.end()?;
        } else {
            lock(&self.idle).push(worker);
        }
        Ok(answer)
    }

    /// Names a test that has become slow.
    fn in_time(&self, selected: &Selected, seconds: f64, answer: Answer) -> Result<Answer, String> {
        if seconds < SLOW || self.slow.contains(&selected.name) {
            return Ok(answer);
        }
        let problem = format!(
            "{}::{} took {seconds:.0} s: make it shorter, or list it in tests/slow.txt with a \
             reason",
            self.group, selected.name
        );
        if self.enforce_times {
            return Err(problem);
        }
        eprintln!("warning: {problem}");
        Ok(answer)
    }

    /// Adds a line to the file of results.
    fn record(&self, outcome: &str, seconds: f64, test: &str, reason: &str) {
        let Some(path) = env::var_os("EFFIGY_TEST_RESULTS") else {
            return;
        };
        let label = env::var("EFFIGY_TEST_LABEL").unwrap_or_else(|_| "-".into());
        let line = format!(
            "{outcome} {seconds:.2} {label} {}::{test} {reason}\n",
            self.group
        );
        let file = OpenOptions::new().create(true).append(true).open(&path);
        if let Err(error) = file.and_then(|mut file| file.write_all(line.as_bytes())) {
            eprintln!("warning: cannot write {}: {error}", path.display());
        }
    }
}

/// What a worker says of a test.
enum Answer {
    Passed,
    Failed(String),
    NotRun(String),
}

/// A process that runs tests, one at a time.
struct Worker {
    process: Child,
    stream: BufReader<TcpStream>,
    /// All that the process prints.
    output: File,
    _file: tempfile::NamedTempFile,
}

impl Drop for Worker {
    fn drop(&mut self) {
        // It may have ended already.
        let _ = self.process.kill();
        let _ = self.process.wait();
    }
}

impl Worker {
    fn start() -> Result<Self, String> {
        Self::try_start().map_err(|error| format!("a worker cannot start: {error}"))
    }

    fn try_start() -> std::io::Result<Self> {
        let file = tempfile::NamedTempFile::new()?;
        // Both streams write at one place in the file.
        let printed = file.reopen()?;
        let listener = TcpListener::bind(("127.0.0.1", 0))?;
        listener.set_nonblocking(true)?;
        // What was measured for the user, or in another group, must not decide how tests draw.
        let cache = Path::new(env!("CARGO_TARGET_TMPDIR"))
            .join("cache")
            .join(env!("CARGO_CRATE_NAME"));
        let process = Command::new(env::current_exe()?)
            .env("XDG_CACHE_HOME", cache)
            .env(PORT, listener.local_addr()?.port().to_string())
            .stdin(Stdio::null())
            .stdout(printed.try_clone()?)
            .stderr(printed)
            .spawn()?;
        let begin = Instant::now();
        let stream = loop {
            match listener.accept() {
                Ok((stream, _)) => break stream,
                Err(_) if begin.elapsed() < PATIENCE => thread::sleep(Duration::from_millis(2)),
                Err(error) => return Err(error),
            }
        };
        stream.set_nonblocking(false)?;
        stream.set_nodelay(true)?;
        Ok(Self {
            process,
            stream: BufReader::new(stream),
            output: file.reopen()?,
            _file: file,
        })
    }

    /// Has a test run. An error is what became of the process.
    fn ask(&mut self, test: &str, limit: Duration) -> Result<Answer, String> {
        // What it printed before is not this test's.
        let _ = self.output.seek(SeekFrom::End(0));
        let mut line = String::new();
        let asked = (|| {
            self.stream.get_ref().set_read_timeout(Some(limit))?;
            writeln!(self.stream.get_mut(), "{test}")?;
            self.stream.read_line(&mut line)
        })();
        let line = line.trim_end();
        let (word, rest) = line.split_once(' ').unwrap_or((line, ""));
        match (asked, word) {
            (Ok(_), "passed") => Ok(Answer::Passed),
            (Ok(_), "failed") => Ok(Answer::Failed(rest.into())),
            (Ok(_), "ignored") => Ok(Answer::NotRun(rest.into())),
            (Err(error), _) if is_timeout(&error) => Err(format!(
                "took longer than {} s and was ended (EFFIGY_TEST_SECONDS)\n{}",
                limit.as_secs(),
                self.said()
            )),
            _ => {
                let status = self.status();
                Err(format!("the process ended: {status}\n{}", self.said()))
            }
        }
    }

    /// How the process ended, in words.
    fn status(&mut self) -> String {
        let begin = Instant::now();
        while begin.elapsed() < Duration::from_secs(5) {
            if let Ok(Some(status)) = self.process.try_wait() {
                return ExitStatus::to_string(&status);
            }
            thread::sleep(Duration::from_millis(10));
        }
        "it closed its connection".into()
    }

    /// The end of what the last test printed.
    fn said(&mut self) -> String {
        const MOST: usize = 6000;
        let mut bytes = vec![];
        let _ = self.output.read_to_end(&mut bytes);
        let text = String::from_utf8_lossy(&bytes);
        match text.char_indices().rev().nth(MOST) {
            Some((from, _)) => format!("…{}", &text[from..]),
            None => text.into_owned(),
        }
    }

    /// Ends the process, which destroys its devices first.
    fn end(mut self) -> Result<(), String> {
        match self.ask(END, PATIENCE)? {
            Answer::Passed => Ok(()),
            Answer::Failed(problem) | Answer::NotRun(problem) => {
                Err(format!("{problem}\n{}", self.said()))
            }
        }
    }
}

fn is_timeout(error: &std::io::Error) -> bool {
    use std::io::ErrorKind::{TimedOut, WouldBlock};
    matches!(error.kind(), TimedOut | WouldBlock)
}

/// The test that this process runs now.
static CURRENT: Mutex<Option<Test>> = Mutex::new(None);

/// Fails a test that opens a device though it is marked as one that needs none.
pub fn assert_device_allowed() {
    if let Some(test) = *lock(&CURRENT) {
        assert!(
            !test.no_device,
            "a test that is marked `no_device` opens one"
        );
    }
}

/// The life of a worker.
fn work(port: &str, tests: &[Selected]) {
    let port: u16 = port.parse().expect("the port is a number");
    let mut stream = TcpStream::connect(("127.0.0.1", port)).expect("the reporting process waits");
    let requests = BufReader::new(stream.try_clone().expect("a socket can be cloned"));
    for request in requests.lines().map_while(Result::ok) {
        let before = validation_messages();
        let answer = match request.as_str() {
            OPEN => match gpu::try_open() {
                Ok(()) => "passed".into(),
                Err(error) => format!("failed {error}"),
            },
            END => {
                gpu::close();
                "passed".into()
            }
            name => perform(name, tests),
        };
        let messages = validation_messages() - before;
        let answer = if answer.starts_with("failed") || messages == 0 {
            answer
        } else {
            format!("failed with {messages} messages of the validation layer, printed above")
        };
        let _ = std::io::stdout().flush();
        if writeln!(stream, "{}", answer.replace('\n', " ")).is_err() || request == END {
            break;
        }
    }
}

/// Runs a test in a thread of its name, which panics show.
fn perform(name: &str, tests: &[Selected]) -> String {
    let Some(selected) = tests.iter().find(|selected| selected.name == name) else {
        return format!("failed there is no test {name}");
    };
    *lock(&CURRENT) = Some(selected.test);
    let thread = thread::Builder::new()
        .name(name.into())
        .spawn(selected.test.run);
    let outcome = thread.expect("a thread can be started").join();
    *lock(&CURRENT) = None;
    match outcome {
        Ok(()) => "passed".into(),
        Err(payload) => match payload.downcast::<NotRun>() {
            Ok(reason) => format!("ignored {}", reason.0),
            Err(_) => "failed".into(),
        },
    }
}
