# SPDX-License-Identifier: BSD-3-Clause
"""Stands between a node and its roscore, and does to single calls what a bad day does: no answer, a late one, a wrong one.

    with MasterProxy(ros.uri) as master:
        master.first("lookupNode", 3, MasterProxy.hang_up)
        ros.start(["camera_node"], env={"ROS_MASTER_URI": master.uri})

Calls without a rule are passed on as they are.
"""
import http.server
import threading
import urllib.request
import xmlrpc.client


class MasterProxy:
    def __init__(self, master_uri):
        self.master_uri = master_uri
        self._rules = {}
        self._changed = threading.Condition()
        self._counts = {}
        proxy = self

        class Handler(http.server.BaseHTTPRequestHandler):
            protocol_version = "HTTP/1.1"

            def do_POST(self):
                proxy.handle(self)

            def log_message(self, *args):
                pass

        self._server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), Handler)
        self._server.daemon_threads = True
        self.uri = f"http://127.0.0.1:{self._server.server_port}"

    def __enter__(self):
        threading.Thread(target=self._server.serve_forever, daemon=True).start()
        return self

    def __exit__(self, *exc):
        with self._changed:
            self._rules.clear()
            self._changed.notify_all()
        self._server.shutdown()
        self._server.server_close()

    def first(self, method, count, rule):
        """The first `count` calls of a method from now on get what rule(self, number, parameters) returns."""
        with self._changed:
            self._rules[method] = (self._counts.get(method, 0) + count, rule)

    def calls(self, method):
        with self._changed:
            return self._counts.get(method, 0)

    def hang_up(self, number, parameters):
        """Ends the connection instead of answering."""
        raise ConnectionError

    def wait_for_another(self, number, parameters):
        """No answer before the caller has lost patience and calls once more; then none, either."""
        with self._changed:
            self._changed.wait_for(lambda: self._counts["lookupNode"] > number or not self._rules, 30)
        raise ConnectionError

    def unknown(self, number, parameters):
        """What the master says of a node that it does not know."""
        return [-1, f"unknown node [{parameters[1]}]", ""]

    def handle(self, request):
        body = request.rfile.read(int(request.headers["Content-Length"]))
        parameters, method = xmlrpc.client.loads(body)
        with self._changed:
            number = self._counts[method] = self._counts.get(method, 0) + 1
            last, rule = self._rules.get(method, (0, None))
            self._changed.notify_all()
        try:
            self.answer(request, self.dump(rule(self, number, parameters)) if number <= last else self.pass_on(body))
        except OSError:  # meant so, or the caller has gone
            request.close_connection = True

    @staticmethod
    def answer(request, body):
        request.send_response(200)
        request.send_header("Content-Type", "text/xml")
        request.send_header("Content-Length", str(len(body)))
        request.end_headers()
        request.wfile.write(body)

    @staticmethod
    def dump(value):
        return xmlrpc.client.dumps((value,), methodresponse=True, allow_none=True).encode()

    def pass_on(self, body):
        call = urllib.request.Request(self.master_uri, body, {"Content-Type": "text/xml"})
        with urllib.request.urlopen(call) as answer:
            return answer.read()
