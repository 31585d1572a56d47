"""Runs the parts of a trade as jobs of a HyperQueue server, and those that die again.

The only argument is a JSON document: command (without --shard), parts, workers, server (folder of a running server, or null).
Every part keeps its points as it finishes them, so nothing but the point in hand is lost with it.
"""

import json
import os
import sys
import tempfile

from hyperqueue import Job
from hyperqueue.client import Client
from hyperqueue.cluster import LocalCluster, WorkerConfig

ATTEMPTS = 3


def submit(client, request, part, logs):
    job = Job()
    shard = ["--shard", f"{part}/{request['parts']}"]
    log = os.path.join(logs, f"part-{part}.log")
    job.program(request["command"] + shard, cwd=os.getcwd(), stdout=None, stderr=log)
    return client.submit(job)


def run(client, request, logs):
    """The parts that failed every time."""
    left = range(1, request["parts"] + 1)
    for attempt in range(ATTEMPTS):
        jobs = {part: submit(client, request, part, logs) for part in left}
        ids = {job.id: part for part, job in jobs.items()}
        failed = client.connection.wait_for_jobs(tuple(ids), lambda _: None)
        left = [ids[job] for job in failed]
        if not left:
            break
        again = "again" if attempt + 1 < ATTEMPTS else "for the last time"
        print(f"parts {left} ended early {again}", file=sys.stderr)
    return left


def main():
    request = json.loads(sys.argv[1])
    with tempfile.TemporaryDirectory() as logs:
        if request["server"]:
            left = run(Client(request["server"]), request, logs)
        else:
            with LocalCluster(os.path.join(logs, "server")) as cluster:
                for _ in range(request["workers"]):
                    cluster.start_worker(WorkerConfig(cores=1))
                left = run(cluster.client(), request, logs)
        if left:
            with open(os.path.join(logs, f"part-{left[0]}.log")) as log:
                sys.exit(f"part {left[0]}: {log.read().strip() or 'killed'}")


main()
