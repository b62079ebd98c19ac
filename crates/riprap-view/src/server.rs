//! HTTP on the loopback address: the embedded page and the answers about the runs.
//!
//! Who may ask: this machine only, and of its users those who know the random part of the address, which is printed on the
//! terminal. A browser is started with an address that works once, since the command lines of a machine can be read by all
//! its users. A page of another site that has its own name resolve to 127.0.0.1 (DNS rebinding) is refused by its `Host` header,
//! and no answer may be read or framed by other sites. Nothing can be changed through it. A connection without a request is closed
//! after `PATIENCE`, and at most `CONNECTIONS` are answered at a time.

use axum::Router;
use axum::body::Body;
use axum::extract::{Request, State};
use axum::http::{HeaderValue, Method, Response, StatusCode, Uri, header};
use std::io;
use std::net::{Ipv4Addr, SocketAddr, TcpListener};
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

use hyper_util::rt::{TokioIo, TokioTimer};
use hyper_util::service::TowerToHyperService;
use tokio::sync::Semaphore;

use crate::answer::{Answer, Query, answer};
use crate::run::{Problem, Run};

/// First port tried when none is asked for.
pub const PORT: u16 = 8470;
/// Ports tried after the first, before the system is asked for any free one.
const NEXT_PORTS: u16 = 20;
/// How long a connection may take to ask.
const PATIENCE: Duration = Duration::from_secs(10);
/// Connections at a time; further ones wait.
const CONNECTIONS: usize = 64;
/// Pause after the system refused a connection, for instance because too many files are open.
const REFUSED: Duration = Duration::from_millis(50);

const PAGE: &[u8] = include_bytes!("../assets/index.html");
const SCRIPT: &[u8] = include_bytes!("../assets/app.js");
const STYLE: &[u8] = include_bytes!("../assets/app.css");

/// The page may load from here only, and run no inline scripts.
const POLICY: &str = "default-src 'none'; script-src 'self'; style-src 'self' 'unsafe-inline'; \
     img-src 'self' data: blob:; media-src blob:; connect-src 'self'; worker-src blob:; \
     base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

/// Why nothing is served.
#[derive(Debug, thiserror::Error)]
pub enum ServerError {
    /// No port is free.
    #[error("could not listen on 127.0.0.1:{port}: {source}")]
    Listen {
        /// The port asked for.
        port: u16,
        /// What the system said.
        source: io::Error,
    },
    /// No random numbers for the address.
    #[error("the system provides no random numbers for the address of the viewer: {0}")]
    Random(getrandom::Error),
    /// It broke down.
    #[error("the viewer stopped: {0}")]
    Serve(#[from] io::Error),
}

/// A server that has its port and does not answer yet.
#[derive(Debug)]
pub struct Server {
    listener: TcpListener,
    address: SocketAddr,
    runs: Arc<Vec<Run>>,
    secret: String,
    once: String,
}

/// 128 random bits, as 32 digits.
fn random() -> Result<String, ServerError> {
    let mut bytes = [0u8; 16];
    getrandom::fill(&mut bytes).map_err(ServerError::Random)?;
    Ok(bytes.iter().map(|b| format!("{b:02x}")).collect())
}

impl Server {
    /// Takes the port, or one of the next if it is in use, or any free one.
    ///
    /// # Errors
    /// No port can be had, or no random numbers.
    pub fn bind(runs: &[PathBuf], port: Option<u16>) -> Result<Self, ServerError> {
        let first = port.unwrap_or(PORT);
        let tried = (0..=NEXT_PORTS).map(|k| first.saturating_add(k)).chain([0]);
        let mut problem = None;
        for port in tried {
            match TcpListener::bind((Ipv4Addr::LOCALHOST, port)) {
                Ok(listener) => {
                    return Ok(Server {
                        address: listener.local_addr()?,
                        listener,
                        runs: Arc::new(runs.iter().map(|r| Run::new(r)).collect()),
                        secret: random()?,
                        once: random()?,
                    });
                }
                // What is reported is about the port that was asked for.
                Err(error) => problem = problem.or(Some(error)),
            }
        }
        Err(ServerError::Listen {
            port: first,
            source: problem.unwrap_or_else(|| io::Error::from(io::ErrorKind::AddrInUse)),
        })
    }

    /// Address of the page; whoever knows it can read the runs.
    pub fn url(&self) -> String {
        format!("http://{}/{}/", self.address, self.secret)
    }

    /// Address that leads to the page once: for the command line of a browser, which other users can see.
    pub fn url_once(&self) -> String {
        format!("http://{}/{}", self.address, self.once)
    }

    /// Answers until the process ends.
    ///
    /// # Errors
    /// The network breaks down.
    pub fn run(self) -> Result<(), ServerError> {
        // A browser takes a second to start: what it asks for first is ready then.
        let runs = Arc::clone(&self.runs);
        std::thread::spawn(move || runs.iter().for_each(Run::prepare));
        let threads = std::thread::available_parallelism().map_or(2, |n| n.get().clamp(2, 4));
        let runtime = tokio::runtime::Builder::new_multi_thread()
            // It only waits: answers are made on the threads for what blocks.
            .worker_threads(1)
            .max_blocking_threads(threads)
            .enable_all()
            .build()?;
        runtime.block_on(async {
            self.listener.set_nonblocking(true)?;
            let listener = tokio::net::TcpListener::from_std(self.listener)?;
            let state = Context {
                runs: self.runs,
                port: self.address.port(),
                secret: self.secret.into(),
                once: self.once.into(),
                used: Arc::new(AtomicBool::new(false)),
            };
            let app = Router::new().fallback(handle).with_state(state);
            accept(listener, app).await
        })?;
        Ok(())
    }
}

/// Takes connections for ever.
async fn accept(listener: tokio::net::TcpListener, app: Router) -> io::Result<()> {
    let room = Arc::new(Semaphore::new(CONNECTIONS));
    loop {
        let Ok(place) = Arc::clone(&room).acquire_owned().await else {
            return Err(io::Error::other("the count of connections was closed"));
        };
        let Ok((stream, _)) = listener.accept().await else {
            tokio::time::sleep(REFUSED).await;
            continue;
        };
        let service = TowerToHyperService::new(app.clone());
        tokio::spawn(async move {
            let serving = hyper::server::conn::http1::Builder::new()
                .timer(TokioTimer::new())
                .header_read_timeout(PATIENCE)
                .serve_connection(TokioIo::new(stream), service);
            // A browser that goes away in the middle is no news.
            let _ = serving.await;
            drop(place);
        });
    }
}

#[derive(Clone)]
struct Context {
    runs: Arc<Vec<Run>>,
    port: u16,
    secret: Arc<str>,
    once: Arc<str>,
    /// Whether the address that works once has been used.
    used: Arc<AtomicBool>,
}

impl Context {
    /// The path behind the random part of the address; what to answer where it is not right.
    fn path(&self, uri: &Uri) -> Result<String, Box<Response<Body>>> {
        let path = uri.path().strip_prefix('/').unwrap_or_default();
        let (key, rest) = match path.split_once('/') {
            Some((key, rest)) => (key, Some(rest)),
            None => (path, None),
        };
        if same(key, &self.secret)
            && let Some(rest) = rest
        {
            return Ok(format!("/{rest}"));
        }
        // Looked at and used up in one: of two requests only one gets through.
        if same(key, &self.once) && rest.is_none() && !self.used.swap(true, Ordering::SeqCst) {
            let mut away = plain(StatusCode::SEE_OTHER, "");
            if let Ok(place) = HeaderValue::try_from(format!("/{}/", self.secret)) {
                away.headers_mut().insert(header::LOCATION, place);
            }
            return Err(Box::new(away));
        }
        Err(Box::new(plain(
            StatusCode::FORBIDDEN,
            "Open the viewer by the complete address that riprap printed.\n",
        )))
    }
}

/// Whether two texts are the same, found in a time that does not tell where they differ.
fn same(a: &str, b: &str) -> bool {
    let pairs = a.bytes().zip(b.bytes());
    a.len() == b.len() && pairs.fold(0, |sum, (x, y)| sum | (x ^ y)) == 0
}

async fn handle(State(context): State<Context>, request: Request) -> Response<Body> {
    if !from_here(&request, context.port) {
        return plain(
            StatusCode::FORBIDDEN,
            "This viewer serves only its own machine. Open it by the address that riprap printed.\n",
        );
    }
    if !matches!(*request.method(), Method::GET | Method::HEAD) {
        return plain(StatusCode::METHOD_NOT_ALLOWED, "Only GET requests are served.\n");
    }
    let uri = request.uri().clone();
    let path = match context.path(&uri) {
        Ok(path) => path,
        Err(refused) => return *refused,
    };
    let page = |kind, bytes: &'static [u8]| reply(StatusCode::OK, kind, Body::from(bytes));
    match path.as_str() {
        "/" => page("text/html; charset=utf-8", PAGE),
        "/app.js" => page("text/javascript; charset=utf-8", SCRIPT),
        "/app.css" => page("text/css; charset=utf-8", STYLE),
        _ => {
            let work =
                tokio::task::spawn_blocking(move || about_runs(&context.runs, &path, uri.query()));
            match work.await {
                Ok(response) => response,
                Err(_) => plain(
                    StatusCode::INTERNAL_SERVER_ERROR,
                    "The viewer could not answer; this is a fault in riprap.\n",
                ),
            }
        }
    }
}

/// Whether the browser means this machine, and asks for a page of ours or for nobody's.
fn from_here(request: &Request, port: u16) -> bool {
    let names = [format!("127.0.0.1:{port}"), format!("localhost:{port}"), format!("[::1]:{port}")];
    let text = |name| request.headers().get(name).map(|v: &HeaderValue| v.to_str().unwrap_or("?"));
    let host = text(header::HOST)
        .or_else(|| request.uri().authority().map(axum::http::uri::Authority::as_str));
    let ours = |host: &str| names.iter().any(|n| n.eq_ignore_ascii_case(host));
    let origin = text(header::ORIGIN);
    host.is_some_and(ours)
        && origin.is_none_or(|o| o.strip_prefix("http://").is_some_and(ours))
        && request
            .headers()
            .get("sec-fetch-site")
            .is_none_or(|site| site == "same-origin" || site == "none")
}

/// `/api/runs` and `/api/NUMBER/QUESTION`.
fn about_runs(runs: &[Run], path: &str, asked: Option<&str>) -> Response<Body> {
    let nothing =
        || problem(&Problem::missing(format!("{path} does not exist"), "Reload the page."));
    let Some(rest) = path.strip_prefix("/api/") else {
        return nothing();
    };
    if rest == "runs" {
        let count = serde_json::json!({ "runs": runs.len(), "riprap": env!("CARGO_PKG_VERSION") });
        return reply(StatusCode::OK, "application/json", Body::from(count.to_string()));
    }
    let Some((number, question)) = rest.split_once('/') else {
        return nothing();
    };
    let Some(run) = number.parse::<usize>().ok().and_then(|n| runs.get(n)) else {
        return nothing();
    };
    let Some(question) = decoded(question) else {
        return nothing();
    };
    let query = |key: &str| -> Option<String> {
        let pairs = asked?.split('&').filter_map(|p| p.split_once('='));
        pairs.filter(|p| p.0 == key).map(|p| p.1).find_map(decoded)
    };
    match answer(run, &question, &Query(&query)) {
        Ok(Answer { kind, bytes }) => reply(StatusCode::OK, kind, Body::from(bytes)),
        Err(error) => problem(&error),
    }
}

/// A piece of an address with its `%XX` read; `None` if it is no text.
fn decoded(text: &str) -> Option<String> {
    let mut out = Vec::with_capacity(text.len());
    let mut bytes = text.bytes();
    while let Some(b) = bytes.next() {
        if b != b'%' {
            out.push(b);
            continue;
        }
        let digit = |b: Option<u8>| char::from(b?).to_digit(16);
        let (high, low) = (digit(bytes.next())?, digit(bytes.next())?);
        out.push(u8::try_from(16 * high + low).ok()?);
    }
    String::from_utf8(out).ok().filter(|s| !s.contains('\0'))
}

fn problem(problem: &Problem) -> Response<Body> {
    let code =
        if problem.missing { StatusCode::NOT_FOUND } else { StatusCode::UNPROCESSABLE_ENTITY };
    let text = serde_json::to_string(problem).unwrap_or_default();
    reply(code, "application/json", Body::from(text))
}

fn plain(code: StatusCode, text: &'static str) -> Response<Body> {
    reply(code, "text/plain; charset=utf-8", Body::from(text))
}

fn reply(code: StatusCode, kind: &'static str, body: Body) -> Response<Body> {
    let mut response = Response::new(body);
    *response.status_mut() = code;
    let headers = response.headers_mut();
    for (name, value) in [
        (header::CONTENT_TYPE, kind),
        // A run may go on, or another take its folder: the next answer may be another one.
        (header::CACHE_CONTROL, "no-store"),
        (header::CONTENT_SECURITY_POLICY, POLICY),
        (header::X_CONTENT_TYPE_OPTIONS, "nosniff"),
        (header::REFERRER_POLICY, "no-referrer"),
    ] {
        headers.insert(name, HeaderValue::from_static(value));
    }
    headers.insert("cross-origin-resource-policy", HeaderValue::from_static("same-origin"));
    response
}
