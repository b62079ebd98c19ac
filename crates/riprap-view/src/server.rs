//! HTTP on the loopback address: the embedded page and the answers about the runs.
//!
//! Who may ask: this machine only. A page of another site that has its own name resolve to 127.0.0.1 (DNS rebinding) is
//! refused by its `Host` header, and no answer may be read or framed by other sites. Nothing can be changed through it.

use axum::Router;
use axum::body::Body;
use axum::extract::{Request, State};
use axum::http::{HeaderValue, Method, Response, StatusCode, Uri, header};
use std::io;
use std::net::{Ipv4Addr, SocketAddr, TcpListener};
use std::path::PathBuf;
use std::sync::Arc;

use crate::answer::{Answer, Query, answer};
use crate::run::{Problem, Run};

/// First port tried when none is asked for.
pub const PORT: u16 = 8470;
/// Ports tried after the first, before the system is asked for any free one.
const NEXT_PORTS: u16 = 20;

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
}

impl Server {
    /// Takes the port, or one of the next if it is in use, or any free one.
    ///
    /// # Errors
    /// No port can be had.
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
                    });
                }
                Err(error) => problem = problem.or(Some(error)),
            }
        }
        Err(ServerError::Listen {
            port: first,
            source: problem.unwrap_or_else(|| io::Error::from(io::ErrorKind::AddrInUse)),
        })
    }

    /// Address of the page.
    pub fn url(&self) -> String {
        format!("http://{}/", self.address)
    }

    /// Answers until the process ends.
    ///
    /// # Errors
    /// The network breaks down.
    pub fn run(self) -> Result<(), ServerError> {
        let threads = std::thread::available_parallelism().map_or(2, |n| n.get().clamp(2, 4));
        let runtime = tokio::runtime::Builder::new_multi_thread()
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
            };
            let app = Router::new().fallback(handle).with_state(state);
            axum::serve(listener, app).await
        })?;
        Ok(())
    }
}

#[derive(Clone)]
struct Context {
    runs: Arc<Vec<Run>>,
    port: u16,
}

async fn handle(State(context): State<Context>, request: Request) -> Response<Body> {
    if !from_here(&request, context.port) {
        return plain(
            StatusCode::FORBIDDEN,
            "This viewer answers its own machine only. Open it by the address that riprap printed.\n",
        );
    }
    if !matches!(*request.method(), Method::GET | Method::HEAD) {
        return plain(StatusCode::METHOD_NOT_ALLOWED, "Only GET.\n");
    }
    let uri = request.uri().clone();
    let page = |kind, bytes: &'static [u8]| reply(StatusCode::OK, kind, Body::from(bytes));
    match uri.path() {
        "/" => page("text/html; charset=utf-8", PAGE),
        "/app.js" => page("text/javascript; charset=utf-8", SCRIPT),
        "/app.css" => page("text/css; charset=utf-8", STYLE),
        _ => {
            let work = tokio::task::spawn_blocking(move || about_runs(&context.runs, &uri));
            match work.await {
                Ok(response) => response,
                Err(_) => plain(
                    StatusCode::INTERNAL_SERVER_ERROR,
                    "The viewer could not answer; this is a mistake of riprap.\n",
                ),
            }
        }
    }
}

/// Whether the browser means this machine, and asks for a page of ours or for nobody's.
fn from_here(request: &Request, port: u16) -> bool {
    let names = [
        format!("127.0.0.1:{port}"),
        format!("localhost:{port}"),
        format!("[::1]:{port}"),
    ];
    let text = |name| {
        request
            .headers()
            .get(name)
            .map(|v: &HeaderValue| v.to_str().unwrap_or("?"))
    };
    let host = text(header::HOST).or_else(|| {
        request
            .uri()
            .authority()
            .map(axum::http::uri::Authority::as_str)
    });
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
fn about_runs(runs: &[Run], uri: &Uri) -> Response<Body> {
    let nothing = || {
        problem(&Problem::missing(
            format!("there is nothing at {}", uri.path()),
            "Reload the page.",
        ))
    };
    let Some(rest) = uri.path().strip_prefix("/api/") else {
        return nothing();
    };
    if rest == "runs" {
        let count = serde_json::json!({ "runs": runs.len(), "riprap": env!("CARGO_PKG_VERSION") });
        return reply(
            StatusCode::OK,
            "application/json",
            Body::from(count.to_string()),
        );
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
        let pairs = uri.query()?.split('&').filter_map(|p| p.split_once('='));
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
    let code = if problem.missing {
        StatusCode::NOT_FOUND
    } else {
        StatusCode::UNPROCESSABLE_ENTITY
    };
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
        (header::CACHE_CONTROL, "no-store"),
        (header::CONTENT_SECURITY_POLICY, POLICY),
        (header::X_CONTENT_TYPE_OPTIONS, "nosniff"),
        (header::REFERRER_POLICY, "no-referrer"),
    ] {
        headers.insert(name, HeaderValue::from_static(value));
    }
    headers.insert(
        "cross-origin-resource-policy",
        HeaderValue::from_static("same-origin"),
    );
    response
}
