-- Blobs whose bytes are objects of a bucket (--s3). An object that is no blob stands among the loose ones until it is deleted.

CREATE TABLE s3_blobs (
  tenant     TEXT   NOT NULL,
  digest     TEXT   NOT NULL,
  object     TEXT   NOT NULL,  -- its key, without the prefix of the bucket's address
  size       BIGINT NOT NULL,
  touched_us BIGINT NOT NULL,  -- put or asked for, last
  PRIMARY KEY (tenant, digest)
);

CREATE TABLE s3_loose (
  object   TEXT   PRIMARY KEY,
  tenant   TEXT   NOT NULL,
  state    TEXT   NOT NULL,  -- PUTTING: is about to be a blob; GONE: was one; DAMAGED: the same, and stays for some time
  since_us BIGINT NOT NULL
);
CREATE INDEX s3_loose_by_tenant ON s3_loose (tenant);
