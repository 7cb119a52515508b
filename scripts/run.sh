#!/usr/bin/env bash
# Installs what is missing, builds the tool and the Python package, resamples real scans and a noisy sample of a mechanical part, and
# compares with CGAL's WLOP and EAR. Says at the end how much better and faster that was, and where results and pictures are.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

scripts/install_dependencies.sh user
# The same build folder as that of scripts/test.sh; of it, what `cmake --install build` needs is built, and what makes the noisy part
# and the comparison.
cmake -S . -B build -DCMAKE_BUILD_TYPE=Release -DPython_EXECUTABLE=/usr/bin/python3
cmake --build build -j "$(nproc)" --target l0_resample l0_resample_manual cgal_l0 CGAL_L0_resampling_compiled \
                                       sample_mesh run_l0 baseline_wlop baseline_ear evaluate_point_set

mkdir -p output
data=$(scripts/fetch_demo_data.sh)
tool=(build/bin/l0_resample --force)   # what an earlier run has left is replaced

# A real scan, taken from one side: uneven, with borders and holes that have to stay where they are. And another, of facades and roofs, with
# the most noise and the most edges of all scans in the package.
"${tool[@]}" "$data/points_3/hippo1.ply" output/hippo_resampled.ply --percentage 100 --snapshot output/hippo.png --json output/hippo.json
"${tool[@]}" "$data/points_3/building.ply" output/building_resampled.ply --percentage 60 \
        --snapshot output/building.png --json output/building.json

# A mechanical part with known truth: 110000 points, noise of 0.5 % of the diagonal.
build/bin/sample_mesh "$data/meshes/fandisk.off" output/fandisk_noisy.ply --points 110000 --noise 0.5 --seed 1
for method in default lor alor; do
  "${tool[@]}" output/fandisk_noisy.ply "output/fandisk_$method.ply" --points 60000 --method "$method" \
          --snapshot "output/fandisk_$method.png" --view 1,-1,0.6 --json "output/fandisk_$method.json"
done

# Beside CGAL's methods: points of which the true surface is known, fewer than above as WLOP takes long, and the first scan
compare() { /usr/bin/python3 -B benchmark/L0_resampling/quality/beside_cgal.py build "$@"; }
build/bin/sample_mesh "$data/meshes/fandisk.off" output/fandisk_small.ply --points 30000 --noise 0.5 --seed 1
comparison=$(compare output/fandisk_small.ply output/beside_fandisk --points 18000 --mesh "$data/meshes/fandisk.off" --view 1,-1,0.6
             echo
             compare "$data/points_3/hippo1.ply" output/beside_hippo --points 5000)

cat <<END

Beside CGAL's WLOP and EAR, one run of each on all threads; distances in % of the diagonal:

$comparison

Results, oriented points as PLY:             output/{hippo,building}_resampled.ply  output/fandisk_{default,lor,alor}.ply
Pictures, input on the left, result beside:  output/{hippo,building}.png            output/fandisk_{default,lor,alor}.png
The same, of each method:                    output/beside_{fandisk,hippo}_{wlop,ear,ours}.png
What was done, stage by stage:               output/{hippo,building}.json           output/fandisk_{default,lor,alor}.json
END
