# A static binary and nothing else, not root:
#     docker build -t mhlint . && docker run --rm -v "$PWD:/work:ro" mhlint data/
# For CI systems that run a shell in the image (GitLab), with git for `--since`:
#     docker build --target ci -t mhlint:ci .
FROM rust:1.95-alpine AS build
RUN apk add --no-cache musl-dev
WORKDIR /source
COPY . .
# On Alpine the C library is musl and linked statically.
RUN cargo build --release --locked --bin mhlint

FROM alpine:3.22 AS ci
RUN apk add --no-cache git && adduser -D -u 65532 mhlint && git config --system --add safe.directory '*'
COPY --from=build /source/target/release/mhlint /usr/local/bin/mhlint
USER 65532:65532
WORKDIR /work

FROM scratch
COPY --from=build /source/target/release/mhlint /mhlint
COPY --from=build /source/LICENSE-MIT /source/LICENSE-APACHE /
USER 65532:65532
WORKDIR /work
ENTRYPOINT ["/mhlint"]
