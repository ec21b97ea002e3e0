#pragma once

#include <string>

namespace slicefarm::bench {

/// Benchmarks. Each function prints `key value` rows to stdout and returns the exit code.
int BenchSlice();
int BenchPlanning();
int BenchHop();
int BenchHopWithTls(const std::string& certs);
int BenchMesh();
int BenchWalls(const std::string& outlines);
int BenchExposure(const std::string& polygons);
int BenchLattice();
int BenchRings(const std::string& outlines);
int BenchWaterline(const std::string& models);

}  // namespace slicefarm::bench
