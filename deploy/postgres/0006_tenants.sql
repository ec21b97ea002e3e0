-- Blobs and results of each tenant apart from those of others.

ALTER TABLE blob_pieces DROP CONSTRAINT blob_pieces_digest_fkey, DROP CONSTRAINT blob_pieces_pkey;
ALTER TABLE blobs DROP CONSTRAINT blobs_pkey;
ALTER TABLE blobs ADD COLUMN tenant TEXT NOT NULL DEFAULT '';
ALTER TABLE blob_pieces ADD COLUMN tenant TEXT NOT NULL DEFAULT '';
ALTER TABLE blobs ADD PRIMARY KEY (tenant, digest);
ALTER TABLE blob_pieces ADD PRIMARY KEY (tenant, digest, at);
ALTER TABLE blob_pieces ADD FOREIGN KEY (tenant, digest) REFERENCES blobs (tenant, digest)
  ON DELETE CASCADE ON UPDATE CASCADE;

ALTER TABLE results ADD COLUMN tenant TEXT NOT NULL DEFAULT '';     -- whose blobs they are
ALTER TABLE jobs ADD COLUMN result_tenant TEXT NOT NULL DEFAULT '';  -- of result: whose blobs they are
