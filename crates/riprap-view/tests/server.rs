//! The server as a browser, a stranger and a person with a broken folder meet it.

use riprap_record::exec::Exec;
use riprap_record::frame::{BRICK, Solids};
use riprap_record::names::Names;
use riprap_record::{Column, Ended, Existing, Frame, Manifest, RunFolder};
use riprap_view::Server;
use serde_json::Value;
use std::io::{Read, Write};
use std::net::{SocketAddr, TcpListener, TcpStream};
use std::path::{Path, PathBuf};
use std::time::Duration;

/// A row of bricks, each moved along x a little more than the one before, at frame `k`.
fn row(bricks: usize, k: usize) -> Frame {
    let mut frame = Frame {
        step: 10 * k as u64,
        time: 1e-3 * k as f64,
        phase: "pull".to_owned(),
        offsets: vec![0],
        ..Frame::default()
    };
    let mut shifts = Vec::new();
    for b in 0..bricks {
        let shift = 0.01 * (k * b) as f64;
        frame.points.extend(
            BRICK.map(|c| [1000.0 + b as f64 + shift + 0.5 * c[0], 0.5 * c[1], 0.5 * c[2]]),
        );
        frame.offsets.push(frame.points.len() as u32);
        shifts.push([shift, 0.0, 0.0]);
    }
    frame.solids = Some(Solids { faces: vec![0; bricks + 1], ends: vec![0], corners: Vec::new() });
    frame.block_columns = vec![
        Column::scalar("block", "-", (0..bricks).map(|b| b as f64).collect()),
        Column::vector3("displacement", "m", shifts),
    ];
    frame.contact_points = vec![[1000.5, 0.0, 0.0]];
    frame.contact_columns = vec![
        Column::scalar("block_a", "-", vec![0.0]),
        Column::scalar("block_b", "-", vec![1.0]),
        Column::scalar("broken_points", "-", vec![2.0]),
        Column::vector3("force_on_a", "N", [[5.0, 0.0, 0.0]]),
    ];
    frame
}

fn write_run(path: &Path, frames: usize) {
    let mut manifest = Manifest { title: "a row of bricks".to_owned(), ..Manifest::default() };
    let mut run = RunFolder::create(path, Existing::Refuse, &manifest).unwrap();
    let names = (1..=4).map(|k| format!("row.{k}"));
    run.write_names(&Names::pack(names, [("row", &[0, 1, 2, 3][..])])).unwrap();
    run.begin_histories(&[("slip", "m")]).unwrap();
    for k in 0..frames {
        run.frame(&row(4, k), &Exec::serial()).unwrap();
        run.history_row(10 * k as u64, 1e-3 * k as f64, &[Some(0.5)]).unwrap();
    }
    manifest.ended = Ended::Finished;
    run.write_manifest(&manifest).unwrap();
}

/// A server that answers, and what its address begins with.
#[derive(Clone)]
struct Site {
    address: SocketAddr,
    /// `/` and the random part.
    root: String,
    /// The path that works once.
    once: String,
}

impl Site {
    fn port(&self) -> u16 {
        self.address.port()
    }
}

impl std::fmt::Display for Site {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        self.address.fmt(f)
    }
}

/// A server over folders; it ends with the test program.
fn serve(folders: &[PathBuf]) -> Site {
    let server = Server::bind(folders, None).unwrap();
    let (url, once) = (server.url(), server.url_once());
    std::thread::spawn(move || server.run());
    let (address, root) = url["http://".len()..].trim_end_matches('/').split_once('/').unwrap();
    let once = once.rsplit_once('/').unwrap().1;
    Site { address: address.parse().unwrap(), root: format!("/{root}"), once: format!("/{once}") }
}

struct Reply {
    code: u16,
    head: String,
    body: Vec<u8>,
}

impl Reply {
    fn json(&self) -> Value {
        serde_json::from_slice(&self.body).unwrap()
    }
}

fn ask(site: &Site, method: &str, path: &str, headers: &str) -> Reply {
    ask_at(site, method, &format!("{}{path}", site.root), headers)
}

fn ask_at(site: &Site, method: &str, path: &str, headers: &str) -> Reply {
    let mut stream = TcpStream::connect(site.address).unwrap();
    write!(stream, "{method} {path} HTTP/1.1\r\n{headers}Connection: close\r\n\r\n").unwrap();
    let mut bytes = Vec::new();
    stream.read_to_end(&mut bytes).unwrap();
    let end = bytes.windows(4).position(|w| w == b"\r\n\r\n").unwrap();
    let head = String::from_utf8_lossy(&bytes[..end]).into_owned();
    Reply {
        code: head.split(' ').nth(1).unwrap().parse().unwrap(),
        head: head.to_lowercase(),
        body: bytes[end + 4..].to_vec(),
    }
}

fn get(site: &Site, path: &str) -> Reply {
    let address = site.address;
    ask(site, "GET", path, &format!("Host: {address}\r\n"))
}

#[test]
fn a_run_is_told_frame_by_frame() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("a.run");
    write_run(&path, 3);
    let site = serve(std::slice::from_ref(&path));
    let page = get(&site, "/");
    assert_eq!(page.code, 200);
    assert!(page.head.contains("content-security-policy: default-src 'none'"));
    let summary = get(&site, "/api/0/summary").json();
    assert_eq!(summary["times"], serde_json::json!([0.0, 1e-3, 2e-3]));
    assert_eq!(summary["manifest"]["title"], "a row of bricks");
    assert_eq!(summary["fields"][1]["name"], "displacement");
    assert_eq!(summary["live"], false);
    for (question, code) in [
        ("frame/2", 200),
        ("shape/2", 200),
        ("field/1?name=displacement.x", 200),
        ("field/1?name=displacement%2Ex", 200),
        ("vectors/1?name=displacement", 200),
        ("contacts/1", 200),
        // A run of rigid blocks has none.
        ("cracks/1", 404),
        ("table/histories", 200),
        ("table/energy", 200),
        ("events", 200),
        ("names", 200),
        ("file/histories.csv", 200),
        ("frame/3", 404),
        ("frame/x", 404),
        ("field/1", 404),
        ("field/1?name=nothing", 404),
        ("vectors/1?name=block", 404),
        ("block/1/9", 404),
        ("nothing", 404),
    ] {
        assert_eq!(get(&site, &format!("/api/0/{question}")).code, code, "{question}");
    }
    let block = get(&site, "/api/0/block/2/3").json();
    assert_eq!(block["columns"][1]["values"][0], 0.06);
    assert_eq!(block["name"], "row.4");
    assert_eq!(block["groups"], serde_json::json!(["row"]));
    assert_eq!(get(&site, "/api/0/names").json()["blocks"][0]["count"], 4);
    // A run of an earlier version has no conditions; one that has a damaged file says which.
    assert_eq!(get(&site, "/api/0/conditions").json(), Value::Null);
    let held = r#"{"faces":[{"name":"floor","kind":"held","count":2,"blocks":[0],"centres":[[0.5,0.5,0.0]],"tractions":[]}]}"#;
    let file = path.join("conditions.json");
    std::fs::write(&file, held).unwrap();
    let damaged = get(&site, "/api/0/conditions");
    assert_eq!(damaged.code, 422);
    assert!(damaged.json().to_string().contains("different lengths"));
    std::fs::write(&file, held.replace("\"count\":2", "\"count\":1")).unwrap();
    let told = get(&site, "/api/0/conditions").json();
    assert_eq!(told["faces"][0]["centres"][0][1], 0.5);
    let history = get(&site, "/api/0/history/3?name=displacement.x&from=1").json();
    assert_eq!(history["values"], serde_json::json!([0.03, 0.06]));
    let range = get(&site, "/api/0/range?name=displacement").json();
    assert_eq!(range["range"], serde_json::json!([0.0, 0.06]));
    assert_eq!(get(&site, "/api/1/summary").code, 404);
    assert_eq!(ask(&site, "POST", "/api/0/summary", &format!("Host: {site}\r\n")).code, 405);
}

#[test]
fn strangers_are_refused() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("a.run");
    write_run(&path, 1);
    let site = serve(&[path]);
    for headers in [
        "Host: evil.example\r\n".to_owned(),
        format!("Host: evil.example:{}\r\n", site.port()),
        "Host: 127.0.0.1\r\n".to_owned(),
        format!("Host: {site}\r\nOrigin: https://evil.example\r\n"),
        format!("Host: {site}\r\nSec-Fetch-Site: cross-site\r\n"),
    ] {
        assert_eq!(ask(&site, "GET", "/api/0/summary", &headers).code, 403, "{headers}");
    }
    let named = format!("Host: localhost:{}\r\nSec-Fetch-Site: same-origin\r\n", site.port());
    assert_eq!(ask(&site, "GET", "/api/0/summary", &named).code, 200);
}

#[test]
fn nothing_outside_the_folder_is_read() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("a.run");
    write_run(&path, 1);
    std::fs::write(dir.path().join("secret.txt"), "secret").unwrap();
    let site = serve(std::slice::from_ref(&path));
    for name in [
        "../secret.txt",
        "..%2Fsecret.txt",
        "%2e%2e/secret.txt",
        "frames/../../secret.txt",
        "/etc/hostname",
        "%2Fetc%2Fhostname",
        "",
        ".",
        "a%00b",
    ] {
        let reply = get(&site, &format!("/api/0/file/{name}"));
        assert!(reply.code == 404 || reply.code == 422, "{name}: {}", reply.code);
        assert!(!String::from_utf8_lossy(&reply.body).contains("secret\n"));
    }
    #[cfg(unix)]
    {
        std::os::unix::fs::symlink(dir.path().join("secret.txt"), path.join("link.txt")).unwrap();
        assert_eq!(get(&site, "/api/0/file/link.txt").code, 404);
    }
    // A list of frames that leads elsewhere.
    let pvd = std::fs::read_to_string(path.join("run.pvd")).unwrap();
    for file in ["../../secret.txt", "frames/../frames/frame_000001.vtu", "/etc/hostname"] {
        std::fs::write(path.join("run.pvd"), pvd.replace("frames/frame_000001.vtu", file)).unwrap();
        assert_eq!(get(&site, "/api/0/frame/0").code, 422, "{file}");
    }
}

#[test]
fn broken_folders_say_what_is_wrong_and_what_to_do() {
    let dir = tempfile::tempdir().unwrap();
    let problem = |site: &Site, what: &str| {
        let summary = get(site, "/api/0/summary").json();
        let said = summary["problem"]["what"].as_str().unwrap_or_default().to_owned();
        assert!(said.contains(what), "{said}");
        assert!(!summary["problem"]["hint"].as_str().unwrap().is_empty());
    };
    let path = dir.path().join("a.run");
    std::fs::create_dir(&path).unwrap();
    let site = serve(std::slice::from_ref(&path));
    problem(&site, "manifest.json");
    write_run(&path.join("case_1"), 1);
    let told = get(&site, "/api/0/summary").json();
    assert!(told["problem"]["hint"].as_str().unwrap().contains("case_1"));
    std::fs::remove_dir_all(&path).unwrap();
    write_run(&path, 3);
    assert!(get(&site, "/api/0/summary").json()["problem"].is_null());

    // One frame cut off: the others are shown.
    let frame = path.join("frames/frame_000002.vtu");
    let bytes = std::fs::read(&frame).unwrap();
    std::fs::write(&frame, &bytes[..bytes.len() / 2]).unwrap();
    let reply = get(&site, "/api/0/frame/1");
    assert_eq!(reply.code, 422);
    assert!(reply.json()["what"].as_str().unwrap().contains("frame_000002.vtu is damaged"));
    assert_eq!(get(&site, "/api/0/frame/2").code, 200);
    let history = get(&site, "/api/0/history/3?name=displacement.x").json();
    assert_eq!(history["values"], serde_json::json!([0.0, null, 0.06]));
    // A frame that is gone.
    std::fs::remove_file(&frame).unwrap();
    assert_eq!(get(&site, "/api/0/frame/1").code, 404);

    // A run whose program died, and one that writes now.
    let manifest = Manifest::default();
    manifest.write(&path).unwrap();
    let summary = get(&site, "/api/0/summary").json();
    assert_eq!((&summary["live"], &summary["died"]), (&Value::Bool(false), &Value::Bool(true)));
    let going = dir.path().join("b.run");
    let _run = RunFolder::create(&going, Existing::Refuse, &manifest).unwrap();
    let other = serve(std::slice::from_ref(&going));
    let summary = get(&other, "/api/0/summary").json();
    assert_eq!((&summary["live"], &summary["died"]), (&Value::Bool(true), &Value::Bool(false)));
    assert_eq!(summary["times"], serde_json::json!([]));

    let pvd = std::fs::read(path.join("run.pvd")).unwrap();
    std::fs::write(path.join("run.pvd"), &pvd[..pvd.len() - 20]).unwrap();
    problem(&site, "run.pvd");
    let text = std::fs::read_to_string(path.join("manifest.json")).unwrap();
    std::fs::write(path.join("manifest.json"), &text[..40]).unwrap();
    problem(&site, "manifest.json");
    std::fs::write(
        path.join("manifest.json"),
        text.replace("\"format_version\": 1", "\"format_version\": 99"),
    )
    .unwrap();
    problem(&site, "99");
}

#[test]
fn a_port_in_use_moves_on() {
    let taken = TcpListener::bind("127.0.0.1:0").unwrap();
    let port = taken.local_addr().unwrap().port();
    let server = Server::bind(&[], Some(port)).unwrap();
    assert!(server.url().starts_with("http://127.0.0.1:"));
    assert_ne!(server.url(), format!("http://127.0.0.1:{port}/"));
}

#[test]
fn who_does_not_know_the_address_reads_nothing() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("a.run");
    write_run(&path, 1);
    let site = serve(std::slice::from_ref(&path));
    let host = format!("Host: {site}\r\n");
    let code = |path: &str| ask_at(&site, "GET", path, &host).code;
    let wrong = format!("/{}/api/0/summary", "0".repeat(32));
    let cut = format!("{}/api/0/summary", &site.root[..site.root.len() - 1]);
    for path in ["/", "/api/runs", "/api/0/summary", "/app.js", &wrong, &cut, &site.root] {
        assert_eq!(code(path), 403, "{path}");
    }
    assert_eq!(code(&format!("{}/api/0/summary", site.root)), 200);
    assert_ne!(site.root, serve(std::slice::from_ref(&path)).root);
    // The address on the command line of the browser leads there once.
    let first = ask_at(&site, "GET", &site.once, &host);
    assert_eq!(first.code, 303);
    assert!(first.head.contains(&format!("location: {}/", site.root)), "{}", first.head);
    assert_eq!(code(&site.once), 403);
}

#[test]
fn whoever_says_nothing_does_not_keep_others_out() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("a.run");
    write_run(&path, 1);
    let site = serve(&[path]);
    // More than are answered at a time, each with half a question.
    let silent: Vec<TcpStream> = (0..80)
        .map(|_| {
            let mut stream = TcpStream::connect(site.address).unwrap();
            stream.write_all(b"GET / HTTP/1.1\r\nHost: ").unwrap();
            stream
        })
        .collect();
    assert_eq!(get(&site, "/api/0/summary").code, 200);
    for mut stream in silent {
        stream.set_read_timeout(Some(Duration::from_secs(60))).unwrap();
        let mut said = Vec::new();
        // They are let go, with an answer or without.
        let _ = stream.read_to_end(&mut said);
        assert!(!said.starts_with(b"HTTP/1.1 200"));
    }
}

#[cfg(unix)]
#[test]
fn only_plain_files_are_read() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("a.run");
    write_run(&path, 2);
    let site = serve(std::slice::from_ref(&path));
    for name in [
        "frames/frame_000002.vtu",
        "histories.csv",
        "names.json",
        "conditions.json",
        "events.jsonl",
    ] {
        let file = path.join(name);
        let _ = std::fs::remove_file(&file);
        let made = std::process::Command::new("mkfifo").arg(&file).status().unwrap();
        assert!(made.success());
    }
    // Each of these waited for a writer for ever.
    assert_eq!(get(&site, "/api/0/frame/1").code, 422);
    assert_eq!(get(&site, "/api/0/table/histories").code, 422);
    assert_eq!(get(&site, "/api/0/file/histories.csv").code, 422);
    assert_eq!(get(&site, "/api/0/conditions").code, 422);
    assert_eq!(get(&site, "/api/0/events").code, 200);
    assert_eq!(get(&site, "/api/0/summary").code, 200);
    assert_eq!(get(&site, "/api/0/frame/0").code, 200);
}
