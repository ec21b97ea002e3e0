#!/usr/bin/env python3
"""Checks that the compose files, the Kubernetes manifests and the monitoring match the programs and each other.

    deploy/deploy_test.py [BIN]      folder of the programs (build/bin)

Every program and every flag must appear in `--help`. Every address must be the address of a service, and its port a
port of that service. Selectors, probes, claims and secrets must refer to existing objects. Two further checks run if
their packages are installed: Kubernetes' own types (python3-kubernetes) and Prometheus' own rules (prometheus, for
promtool).
"""
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

import yaml

DEPLOY = pathlib.Path(__file__).resolve().parent
BIN = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else DEPLOY.parent / "build/bin")
COMPOSE = [DEPLOY.parent / "docker-compose.yml", *sorted(DEPLOY.glob("compose.*.yml"))]
OUR_IMAGES = {"slicefarm", "slicefarm-postgres", "slicefarm-prometheus"}
OTHER_IMAGES = re.compile(r"docker\.io/grafana/grafana:\d+\.\d+\.\d+")  # a fixed release, not the latest one
PROFILES = {"split", "monitoring"}
PORT, METRICS_PORT = 50051, 9464  # as deploy/Dockerfile exposes them
problems = []


def expect(condition, message):
    if not condition:
        problems.append(message)


PROXY = "slicefarm-proxy"  # deploy/proxy/proxy.sh in the image


def flags_of(program, cache={}):
    if program == PROXY:
        return set(re.findall(r"^#?\s*(--[a-z][a-z-]*)", (DEPLOY / "proxy/proxy.sh").read_text(), re.M)) | {"--listen", "--coordinators"}
    if program not in cache:
        expect((BIN / program).exists(), f"there is no program {program}")
        run = subprocess.run([BIN / program, "--help"], stdout=subprocess.PIPE, text=True) if (BIN / program).exists() else None
        cache[program] = set(re.findall(r"--[a-z][a-z-]*", run.stdout)) if run else set()
    return cache[program]


def check_command(where, words, services):
    """Checks a command line of one of our programs and the addresses in it; {name: port} are the ports of the services."""
    program, values = words[0], {}
    for word in words[1:]:
        if word.startswith("--"):
            flag, _, value = word.partition("=")
            values[flag] = value
        elif values:
            values[flag] = word
    for flag in values:
        expect(flag in flags_of(program), f"{where}: {program} has no {flag}")
    for flag, value in values.items():
        if flag not in ("--slicing", "--planning", "--motion", "--exposure", "--milling", "--texture", "--workers", "--beading", "--infill", "--ordering", "--coordinators"):
            continue
        for address in value.split(","):
            name, _, port = address.partition(":")
            expect(services.get(name) == int(port), f"{where}: {flag} {address} is no service's address")
    expect(values.get("--listen") == f"0.0.0.0:{PORT}", f"{where}: listens on {values.get('--listen')}")
    metrics_port = None if program == PROXY else str(METRICS_PORT)
    expect(values.get("--metrics-port") == metrics_port, f"{where}: metrics on {values.get('--metrics-port')}")
    return values


def interpolated(text):
    return re.sub(r"\$\{\w+:-([^}]*)\}", r"\1", text)


def check_rights(at, service):
    """Checks that a container has limits for memory and logs, no capabilities and a read-only image."""
    expect(service.get("cap_drop") == ["ALL"], f"{at}: capabilities")
    expect("no-new-privileges:true" in service.get("security_opt", []), f"{at}: may get new privileges")
    expect(re.fullmatch(r"\d+[mg]", interpolated(service.get("mem_limit", ""))), f"{at}: no memory limit")
    expect(set(service["logging"].get("options", {})) == {"max-size", "max-file"}, f"{at}: logs without a bound")
    expect(service.get("read_only") or service["image"] not in OUR_IMAGES, f"{at}: may write to its image")
    expect(service.get("restart") == "unless-stopped", f"{at}: stays away after a failure")


def check_split_stages():
    """Checks the command that docker-compose.yml gives for the profile `split`."""
    text = (DEPLOY.parent / "docker-compose.yml").read_text()
    services = {name: PORT for name in yaml.safe_load(text)["services"]}
    stages = re.search(r'STAGES="(.*?)"', text)[1]
    check_command("docker-compose.yml: STAGES", ["slicefarm-coordinator", f"--listen=0.0.0.0:{PORT}",
                                                 f"--metrics-port={METRICS_PORT}", *stages.split()], services)


def check_compose(path):
    where = path.name
    compose = yaml.safe_load(path.read_text())
    expect(compose["networks"]["farm"] == {"internal": True}, f"{where}: the farm's own network leads outside")
    services = compose["services"]
    ours = {name: PORT for name, service in services.items() if service.get("command")}
    for name, service in services.items():
        at = f"{where}: {name}"
        ours_at_all = service["image"] in OUR_IMAGES
        expect(ours_at_all or OTHER_IMAGES.fullmatch(service["image"]), f"{at}: image {service['image']}")
        expect(("build" in service) == ours_at_all, f"{at}: is built nowhere, or somewhere else")
        if build := service.get("build"):
            context = (path.parent / build["context"]).resolve()
            expect((context / build["dockerfile"]).exists(), f"{at}: no {build['dockerfile']} in {context}")
            expect("ARG BASE=" in (context / build["dockerfile"]).read_text(), f"{at}: {build['dockerfile']} takes no BASE")
        profiles = set(service.get("profiles", []))
        expect(profiles <= PROFILES, f"{at}: profiles {profiles}")
        for other in service.get("depends_on", []):
            expect(other in services, f"{at}: depends on {other}")
            expect(set(services[other].get("profiles", [])) <= profiles, f"{at}: {other} may not be started")
        expect(set(service.get("networks", [])) <= set(compose["networks"]), f"{at}: networks")
        for volume in service.get("volumes", []):
            source, own = volume.split(":")[0], ":" not in volume and volume.startswith("/")
            known = own or source in compose["volumes"] or (source.startswith("./") and (path.parent / source).exists())
            expect(known, f"{at}: volume {volume}")
        if "SLICEFARM_POSTGRES" in service.get("environment", {}):  # /tmp is in memory
            expect(any(f"--spool {volume}" in service["command"] for volume in service.get("volumes", [])), f"{at}: spool in memory")
        check_rights(at, service)
        if not service.get("command"):
            continue
        values = check_command(at, interpolated(service["command"]).split(), ours)
        drain = int(values.get("--drain", 30))
        expect(int(service["stop_grace_period"].rstrip("s")) > drain, f"{at}: killed before it has drained")
        expect(int(interpolated(service["ulimits"]["nofile"]["hard"])) >= 65536, f"{at}: few descriptors")
        expect(service["healthcheck"]["test"][1:] == ["slicefarm", "health", f"127.0.0.1:{PORT}"], f"{at}: health")
        # A client that reaches gRPC's own server without the door can end it.
        expect(name == "proxy" or not service.get("ports"), f"{at}: is published beside the door")
        outside = {"farm", "outside"} if name == "coordinator" else {"farm", "clients"} if name == "proxy" else {"farm"}
        expect(set(service["networks"]) == outside, f"{at}: networks {service['networks']}")
        for port in service.get("ports", []):
            expect(interpolated(port).rsplit(":", 1)[-1] == str(PORT), f"{at}: publishes {port}")


def check_dockerfile():
    text = (DEPLOY / "Dockerfile").read_text()
    expect(f"EXPOSE {PORT} {METRICS_PORT}" in text, "Dockerfile: other ports than the compose files'")
    expect("--target programs" in text, "Dockerfile: builds more than a farm's programs")
    for source in re.findall(r"^COPY (?!--from)(\S+) ", text, re.M):
        expect((DEPLOY.parent / source).exists(), f"Dockerfile: no {source}")
    cmake = (DEPLOY.parent / "CMakeLists.txt").read_text()
    for folder in re.findall(r"^add_subdirectory\((\w+)\)", cmake, re.M):
        expect(f"COPY {folder} {folder}" in text, f"Dockerfile: builds without {folder}")


def check_migration():
    """Checks that the migration job runs one of our commands, with the rights and the secret of the coordinators."""
    job, policy = yaml.safe_load_all((DEPLOY / "kubernetes/migrate/job.yaml").read_text())
    pod = job["spec"]["template"]
    container, = pod["spec"]["containers"]
    run = subprocess.run([BIN / container["command"][0], *container["command"][1:], "--help"], stdout=subprocess.PIPE, text=True)
    expect(run.returncode == 0 and "SLICEFARM_POSTGRES" in run.stdout, "kubernetes: the job `migrate` runs no program of ours")
    expect([variable["name"] for variable in container["env"]] == ["SLICEFARM_POSTGRES"], "kubernetes: migrate: where to?")
    rights = container["securityContext"]
    expect(pod["spec"]["securityContext"]["runAsNonRoot"] and rights["readOnlyRootFilesystem"]
           and rights["capabilities"] == {"drop": ["ALL"]}, "kubernetes: migrate: too many rights")
    expect(policy["spec"]["podSelector"]["matchLabels"].items() <= pod["metadata"]["labels"].items(), "kubernetes: migrate: policy")


def check_bucket():
    """Checks that the compose files and the component `s3` set all environment variables that the programs read for a
    bucket, and no other variables.
    """
    run = subprocess.run([BIN / "slicefarm-coordinator", "--help"], stdout=subprocess.PIPE, text=True)
    wanted = {"AWS_ACCESS_KEY_ID", "AWS_SECRET_ACCESS_KEY", *re.findall(r"Env:(SLICEFARM_S3|AWS_\w+)", run.stdout)}
    expect(len(wanted) == 4, f"the coordinator's --help names {wanted}")
    for path in COMPOSE:
        names = set(yaml.safe_load(path.read_text())["services"]["coordinator"].get("environment", {}))
        expect(wanted <= names, f"{path.name}: a bucket needs {wanted - names}")
    component = yaml.safe_load((DEPLOY / "kubernetes/s3/kustomization.yaml").read_text())
    added = [step["value"] for patch in component["patches"] for step in yaml.safe_load(patch["patch"])]
    expect({value["name"] for value in added if "name" in value} == wanted, "kubernetes: s3: other variables")
    expect(any(port["port"] == 443 for value in added for port in value.get("ports", [])), "kubernetes: s3: no way out")


def check_secure_override():
    """Checks that deploy/secure.yml gives a certificate of its own to each of our services in docker-compose.yml."""
    services = yaml.safe_load((DEPLOY.parent / "docker-compose.yml").read_text())["services"]
    added = yaml.safe_load((DEPLOY / "secure.yml").read_text())["services"]
    ours = {name for name, service in services.items() if service.get("command")}
    expect(set(added) == ours, f"secure.yml: services {set(added) ^ ours}")
    for name, service in added.items():
        role = name if name in ("coordinator", "proxy", "worker") else f"stage-{name}"
        expect(f"${{CERTS:-./certs}}/{role}:/etc/slicefarm/tls:ro" in service["volumes"], f"secure.yml: {name}: certificate")
        files = {f"SLICEFARM_TLS_{key.upper()}": f"/etc/slicefarm/tls/{key}.pem" for key in ("cert", "key", "ca")}
        expect(service["environment"] == files, f"secure.yml: {name}: environment")


def documents(folder):
    for path in sorted(folder.glob("*.yaml")):
        for document in yaml.safe_load_all(path.read_text()):
            yield path.name, document


class Manifests:
    """Manifests of deploy/kubernetes by kind and name."""

    def __init__(self, folder):
        self.folder = folder
        self.all = [(path, d) for path, d in documents(folder) if d["kind"] != "Kustomization"]
        self.deployments = {d["metadata"]["name"]: d for _, d in self.all if d["kind"] == "Deployment"}
        self.services = {d["metadata"]["name"]: d for _, d in self.all if d["kind"] == "Service"}

    def pods(self):
        return [d["spec"]["template"] for d in self.deployments.values()]

    def ports(self):
        """Returns {service: port} as clients use them."""
        return {name: service["spec"]["ports"][0]["port"] for name, service in self.services.items()}

    def check(self):
        kustomization = yaml.safe_load((self.folder / "kustomization.yaml").read_text())
        expect(sorted(kustomization["resources"] + ["kustomization.yaml"]) == sorted(p.name for p in self.folder.glob("*.yaml")),
               "kubernetes: kustomization.yaml names other files than there are")
        for _, document in self.all:
            getattr(self, "check_" + document["kind"], lambda d: None)(document)
        self.check_tls()

    def check_tls(self):
        """Checks that the component `tls` changes every deployment, under the deployment's own name."""
        component = yaml.safe_load((self.folder / "tls/kustomization.yaml").read_text())
        patches = [yaml.safe_load(patch["patch"]) for patch in component["patches"] if "target" not in patch]
        expect({p["metadata"]["name"] for p in patches} == set(self.deployments), "kubernetes: tls leaves out a deployment")
        for patch in patches:
            name, pod = patch["metadata"]["name"], patch["spec"]["template"]["spec"]
            names = [c["name"] for c in self.deployments[name]["spec"]["template"]["spec"]["containers"]]
            expect([c["name"] for c in pod["containers"]] == names, f"kubernetes: tls for a container that {name} has not")
            mounted = {mount["name"] for c in pod["containers"] for mount in c["volumeMounts"]}
            expect(mounted == {volume["name"] for volume in pod["volumes"]}, f"kubernetes: volumes of tls for {name}")

    def check_Deployment(self, document):
        name, spec = document["metadata"]["name"], document["spec"]
        pod = spec["template"]["spec"]
        labels = spec["template"]["metadata"]["labels"]
        expect(spec["selector"]["matchLabels"].items() <= labels.items(), f"kubernetes: {name} does not select its own pods")
        expect(pod["securityContext"]["runAsNonRoot"] and pod["securityContext"]["seccompProfile"]["type"] == "RuntimeDefault",
               f"kubernetes: {name} runs with too many rights")
        for container in pod["containers"]:
            self.check_container(f"kubernetes: {name}", container, pod["terminationGracePeriodSeconds"])

    def check_container(self, where, container, grace_s):
        values = check_command(where, container["command"] + container["args"], self.ports())
        ports = {port["name"]: port["containerPort"] for port in container["ports"]}
        proxy = container["command"] == [PROXY]
        expect(ports == {"grpc": PORT} | ({} if proxy else {"metrics": METRICS_PORT}), f"{where}: ports {ports}")
        for probe in ("readinessProbe",) if proxy else ("readinessProbe", "livenessProbe"):
            command = " ".join(container[probe]["exec"]["command"]).removeprefix("sh -c ")
            expect(command.startswith(f"slicefarm health 127.0.0.1:{PORT}"), f"{where}: {probe}")
        variables = {variable["name"] for variable in container.get("env", [])}
        for used in re.findall(r"\$\((\w+)\)", " ".join(container["args"])):
            expect(used in variables, f"{where}: $({used}) is not set")
        pause_s = int(container["lifecycle"]["preStop"]["exec"]["command"][-1])
        expect(grace_s > pause_s + int(values.get("--drain", 30)), f"{where}: killed before it has drained")
        rights = container["securityContext"]
        expect(not rights["allowPrivilegeEscalation"] and rights["readOnlyRootFilesystem"]
               and rights["capabilities"] == {"drop": ["ALL"]}, f"{where}: too many rights")
        expect(set(container["resources"]) == {"requests", "limits"}, f"{where}: resources")

    def selected(self, selector):
        """Returns the pods that a selector matches."""
        def fits(labels):
            exact = all(labels.get(k) == v for k, v in (selector.get("matchLabels") or {}).items())
            return exact and all(labels.get(e["key"]) in e["values"] for e in selector.get("matchExpressions", []))
        return [pod for pod in self.pods() if fits(pod["metadata"]["labels"])]

    def check_Service(self, document):
        name, spec = document["metadata"]["name"], document["spec"]
        pods = self.selected({"matchLabels": spec["selector"]})
        expect(len(pods) == 1, f"kubernetes: service {name} selects {len(pods)} kinds of pods")
        for port in spec["ports"]:
            for pod in pods:
                names = [p["name"] for c in pod["spec"]["containers"] for p in c["ports"]]
                expect(port["targetPort"] in names, f"kubernetes: service {name} has no port {port['targetPort']}")
        headless = spec.get("clusterIP") == "None"
        expect(headless == (name != "proxy"), f"kubernetes: service {name} is {'' if headless else 'not '}headless")

    def check_PodDisruptionBudget(self, document):
        expect(len(self.selected(document["spec"]["selector"])) == 1, f"kubernetes: budget {document['metadata']['name']}")

    def check_HorizontalPodAutoscaler(self, document):
        target = document["spec"]["scaleTargetRef"]
        expect(target["kind"] == "Deployment" and target["name"] in self.deployments, "kubernetes: what is scaled?")
        expect("replicas" not in self.deployments[target["name"]]["spec"], "kubernetes: replicas beside an autoscaler")
        adapter = yaml.safe_load((DEPLOY / "monitoring/adapter.yml").read_text())
        made = {rule["name"]["as"] for rule in adapter["rules"]["external"]}
        for metric in document["spec"]["metrics"]:
            expect(metric["external"]["metric"]["name"] in made, f"kubernetes: no external metric {metric['external']}")

    def check_NetworkPolicy(self, document):
        name, spec = document["metadata"]["name"], document["spec"]
        expect(self.selected(spec["podSelector"]), f"kubernetes: policy {name} means no pod")
        for rule in spec.get("ingress", []):
            for port in rule["ports"]:
                expect(port["port"] in ("grpc", "metrics"), f"kubernetes: policy {name}: port {port}")
        for rule in spec.get("ingress", []) + spec.get("egress", []):
            for peer in rule.get("from", []) + rule.get("to", []):
                if "podSelector" in peer:
                    expect(self.selected(peer["podSelector"]), f"kubernetes: policy {name} lets nobody through")
            # Clients may connect to the door only.
            clients = any("slicefarm-clients" in str(peer) for peer in rule.get("from", []))
            expect(not clients or name == "proxy", f"kubernetes: policy {name} lets clients past the door")


# Fields of Kubernetes that are newer than the release of python3-kubernetes in Debian 12 (1.22).
NEWER_FIELDS = {("V1Probe", "grpc"), ("V1ServicePort", "appProtocol")}
NEWER_KINDS = {("autoscaling/v2", "HorizontalPodAutoscaler"): "V2beta2HorizontalPodAutoscaler"}


def check_types(value, kind, where):
    """Checks `value` against Kubernetes' published types: it may contain only known fields of the right type."""
    from kubernetes import client
    if kind.startswith("list["):
        expect(isinstance(value, list), f"{where} is no list")
        for i, item in enumerate(value):
            check_types(item, kind[5:-1], f"{where}[{i}]")
    elif kind.startswith("dict("):
        expect(isinstance(value, dict), f"{where} is no map")
        for key, item in value.items():
            check_types(item, kind[5:-1].split(", ")[1], f"{where}.{key}")
    elif kind in ("str", "int", "bool", "float"):
        fits = {"str": str, "int": int, "bool": bool, "float": (int, float)}[kind]
        expect(isinstance(value, fits), f"{where} = {value!r} is no {kind}")
    elif kind not in ("object", "datetime"):
        model = getattr(client, kind)
        fields = {json_name: model.openapi_types[name] for name, json_name in model.attribute_map.items()}
        for key, item in value.items():
            if (kind, key) in NEWER_FIELDS:
                continue
            expect(key in fields, f"{where}: {kind} has no {key}")
            if key in fields:
                check_types(item, fields[key], f"{where}.{key}")


def check_kubernetes_types(manifests):
    try:
        import kubernetes.client  # noqa: F401  (`kubernetes` alone may be the folder beside this file)
    except ImportError:
        return "not checked: Kubernetes' types (python3-kubernetes is not installed)"
    for path, document in manifests.all:
        group, _, version = document["apiVersion"].rpartition("/")
        kind = NEWER_KINDS.get((document["apiVersion"], document["kind"]), version.capitalize() + document["kind"])
        check_types(document, kind, f"{path}: {document['kind']} {document['metadata']['name']}")
    return "checked: Kubernetes' types"


def check_monitoring():
    monitoring = DEPLOY / "monitoring"
    prometheus = yaml.safe_load((monitoring / "prometheus.yml").read_text())
    services = {name for path in COMPOSE for name, service in yaml.safe_load(path.read_text())["services"].items()
                if service.get("command") and name != "proxy"}
    scraped = prometheus["scrape_configs"][0]["dns_sd_configs"][0]
    expect(set(scraped["names"]) == services, f"prometheus.yml: looks for {scraped['names']}")
    expect(scraped["port"] == METRICS_PORT, "prometheus.yml: port")
    in_kubernetes, = yaml.safe_load((monitoring / "prometheus.kubernetes.yml").read_text())["scrape_configs"]
    expect(in_kubernetes["job_name"] == prometheus["scrape_configs"][0]["job_name"], "prometheus.kubernetes.yml: job")
    made = {rule["target_label"] for rule in in_kubernetes["relabel_configs"] if "target_label" in rule}
    expect(made >= {"service", "namespace"}, f"prometheus.kubernetes.yml: makes only {made}")
    dashboard = json.loads((monitoring / "grafana.json").read_text())
    source, = yaml.safe_load((monitoring / "provisioning/datasources/prometheus.yml").read_text())["datasources"]
    expect(source["url"] == "http://prometheus:9090", "grafana: asks another Prometheus than docker-compose.yml's")
    provider, = yaml.safe_load((monitoring / "provisioning/dashboards/slicefarm.yml").read_text())["providers"]
    compose = (DEPLOY.parent / "docker-compose.yml").read_text()
    expect(f"grafana.json:{provider['options']['path']}/" in compose, "grafana: the dashboard is mounted elsewhere")
    queries = [target["expr"] for panel in dashboard["panels"] for target in panel.get("targets", [])]
    promtool = shutil.which("promtool")
    if not promtool:
        return "not checked: Prometheus' rules (promtool is not installed)"
    for arguments in (["check", "config", "prometheus.yml"], ["test", "rules", "alerts_test.yml"]):
        run = subprocess.run([promtool, *arguments], cwd=monitoring, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        expect(run.returncode == 0, f"promtool {' '.join(arguments)}:\n{run.stdout}")
    rules = [{"record": f"q{i}", "expr": q.replace("$__rate_interval", "5m")} for i, q in enumerate(queries)]
    with tempfile.NamedTemporaryFile("w", suffix=".yml") as file:
        yaml.safe_dump({"groups": [{"name": "dashboard", "rules": rules}]}, file)
        file.flush()
        run = subprocess.run([promtool, "check", "rules", file.name], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    expect(run.returncode == 0, f"promtool on the dashboard's queries:\n{run.stdout}")
    return "checked: Prometheus' rules and the dashboard's queries"


def main():
    for path in COMPOSE:
        check_compose(path)
    check_split_stages()
    check_secure_override()
    check_dockerfile()
    check_migration()
    check_bucket()
    manifests = Manifests(DEPLOY / "kubernetes")
    manifests.check()
    notes = [check_kubernetes_types(manifests), check_monitoring()]
    for problem in problems:
        print(problem)
    print("\n".join(notes))
    sys.exit(1 if problems else 0)


if __name__ == "__main__":
    main()
