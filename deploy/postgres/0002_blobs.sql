-- Blobs by SHA-256, in pieces. A piece begins at its offset; those of a blob follow each other without a gap.

CREATE TABLE blobs (
  digest   TEXT    PRIMARY KEY,
  size     BIGINT  NOT NULL,  -- bytes that are here
  complete BIGINT  NOT NULL,  -- 1: all are, and their digest is the name
  touched  TIMESTAMPTZ NOT NULL DEFAULT now()  -- written or asked for, last
);

CREATE TABLE blob_pieces (
  digest TEXT   NOT NULL REFERENCES blobs (digest) ON DELETE CASCADE ON UPDATE CASCADE,
  at     BIGINT NOT NULL,
  bytes  BYTEA  NOT NULL,
  PRIMARY KEY (digest, at)
);
-- Meshes and G-code do not get smaller by PostgreSQL's own compression at a price worth paying.
ALTER TABLE blob_pieces ALTER COLUMN bytes SET STORAGE EXTERNAL;
