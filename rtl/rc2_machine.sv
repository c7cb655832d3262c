// SPDX-License-Identifier: Apache-2.0
//
// The machine with its host port: AXI4-Lite for control, AXI4-Stream for packets and readback.
//
// Packets in (s_axis, one stream for each row feeder, feeder 0 lowest): one word of a packet per
// beat, tdata = {kind, payload} of rc2_pkg in the low bits. A READ word goes to all feeders.
// Readback (m_axis): one beat per word, tdata = data_t, cells in order of y, then x; a beat without
// meaning and with tlast set ends it.
//
// Registers (32 bits, byte addresses; read-only unless said):
//   00 id "RC2" and layout version   04 n   08 f   0C LMAX   10 FAMAX
//   14 bits of a packet word   18 bits of a readback word   1C bits of a facet number
//   34 a byte each, high to low: fraction bits and bits of a gap, and of a component of a normal
//   38 row feeders   3C 1 if the columns have layers
//   20 command, write 1: bit 0 forget the voxels, bit 1 start the light, bit 2 prepare it: see where
//      it will stop, for the accurate rule; bit 3 forget rays and hits, bit 4 trace the rays that lie in
//      the homes (only while idle)
//   24 status: bit 0 busy (loading, light, or cells still learning how far the scene reaches),
//      bit 1 all targets are home
//   28 cycles in which the array was busy since the last command
//   2C cycles from the last start until the last target came home   30 targets home
//   40 xs   44 ys   48 zs   4C L   50 FA   54 24*L*L+2   58 2^s/L, rounded down, s of register 60
//   (read and write, only while idle and four cycles before a start)
//   68 rays: places of their queues << 8 | most bounces; 0 if the machine traces none
//   6C least weight << 16 | places of a queue in use << 8 | bounces (likewise, before a trace)
//   74 rule of the light: 1 accurate, 0 the thesis's (likewise)
//   5C bit 0: thesis mode, bit 1: the columns count targets, bit 2: in lanes, light that can meet
//      nothing is skipped   60 fraction bits of 1/L   64 of the targets home, those skipped

module rc2_machine (
    input  logic        clk_i,
    input  logic        rst_ni,
    // AXI4-Lite
    input  logic        s_axil_awvalid,
    output logic        s_axil_awready,
    input  logic [ 6:0] s_axil_awaddr,
    input  logic        s_axil_wvalid,
    output logic        s_axil_wready,
    input  logic [31:0] s_axil_wdata,
    output logic        s_axil_bvalid,
    input  logic        s_axil_bready,
    output logic [ 1:0] s_axil_bresp,
    input  logic        s_axil_arvalid,
    output logic        s_axil_arready,
    input  logic [ 6:0] s_axil_araddr,
    output logic        s_axil_rvalid,
    input  logic        s_axil_rready,
    output logic [31:0] s_axil_rdata,
    output logic [ 1:0] s_axil_rresp,
    // AXI4-Stream: packets
    input  logic [rc2_pkg::FEEDERS-1:0]         s_axis_tvalid,
    output logic [rc2_pkg::FEEDERS-1:0]         s_axis_tready,
    input  logic [rc2_pkg::FEEDERS*PacketW-1:0] s_axis_tdata,
    // AXI4-Stream: readback
    output logic        m_axis_tvalid,
    input  logic        m_axis_tready,
    output logic [ReadW-1:0] m_axis_tdata,
    output logic        m_axis_tlast
);
  // A stream's width is a whole number of bytes.
  localparam int unsigned PacketW = 8 * ((rc2_pkg::HostWordW + 7) / 8);
  localparam int unsigned ReadW = 8 * ((rc2_pkg::DataW + 7) / 8);
  localparam int unsigned HomeW = rc2_pkg::HomeW;
  localparam logic [31:0] Id = 32'h52433202;

  rc2_limits u_limits ();

  // ---- The array -----------------------------------------------------------------------------
  logic clear_q, prepare_q, start_q, ray_clear_q, ray_start_q, accurate_q, array_busy, light_busy, busy;
  rc2_pkg::light_t light_q;
  rc2_pkg::limits_t limits_q;
  logic word_valid;
  logic [rc2_pkg::RowWordW-1:0] word;
  logic [HomeW-1:0] home, skipped;
  logic [rc2_pkg::FEEDERS*rc2_pkg::HostWordW-1:0] words;
  for (genvar k = 0; k < rc2_pkg::FEEDERS; k++) begin : g_word
    assign words[k*rc2_pkg::HostWordW+:rc2_pkg::HostWordW] =
        s_axis_tdata[k*PacketW+:rc2_pkg::HostWordW];
  end
  rc2_array u_array (
      .clk_i       (clk_i),
      .rst_ni      (rst_ni),
      .clear_i     (clear_q),
      .prepare_i   (prepare_q),
      .start_i     (start_q),
      .accurate_i  (accurate_q),
      .light_i     (light_q),
      .ray_clear_i (ray_clear_q),
      .ray_start_i (ray_start_q),
      .limits_i    (limits_q),
      .word_valid_i(s_axis_tvalid),
      .word_i      (words),
      .word_ready_o(s_axis_tready),
      .word_valid_o(word_valid),
      .word_o      (word),
      .word_ready_i(m_axis_tready),
      .home_o      (home),
      .skipped_o   (skipped),
      .light_busy_o(light_busy),
      .busy_o      (array_busy)
  );
  assign m_axis_tvalid = word_valid;
  assign m_axis_tlast = (word[rc2_pkg::RowWordW-1-:rc2_pkg::KindW] == rc2_pkg::KindRead);
  assign m_axis_tdata = ReadW'(word[rc2_pkg::DataW-1:0]);

  // After a load the cells need up to 2N cycles to learn where there is anything (rc2_extents).
  localparam int unsigned SettleW = $clog2(2 * rc2_pkg::N + 1);
  logic settling;
  if (rc2_pkg::SKIPS && !rc2_pkg::THESIS) begin : g_settle
    logic lights_q;
    logic [SettleW-1:0] settle_q;
    assign settling = (settle_q != 0);
    always_ff @(posedge clk_i) begin
      if (!rst_ni || clear_q) begin
        lights_q <= 1'b0;
        settle_q <= '0;
      end else begin
        if (prepare_q || start_q) lights_q <= 1'b1;
        if (array_busy && !lights_q) settle_q <= SettleW'(2 * rc2_pkg::N);
        else if (settling) settle_q <= settle_q - 1'b1;
      end
    end
  end else begin : g_settled
    assign settling = 1'b0;
  end
  assign busy = array_busy || light_busy || settling;

  // ---- Registers: write ------------------------------------------------------------------------
  logic write;
  logic [HomeW-1:0] targets_q;
  assign write = s_axil_awvalid && s_axil_wvalid && !s_axil_bvalid;
  assign s_axil_awready = write;
  assign s_axil_wready = write;
  assign s_axil_bresp = 2'b00;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      s_axil_bvalid <= 1'b0;
      clear_q       <= 1'b0;
      prepare_q     <= 1'b0;
      start_q       <= 1'b0;
      ray_clear_q   <= 1'b0;
      ray_start_q   <= 1'b0;
      limits_q      <= '0;
      accurate_q    <= 1'b0;
      light_q       <= '0;
      targets_q     <= '0;
    end else begin
      s_axil_bvalid <= write || (s_axil_bvalid && !s_axil_bready);
      clear_q       <= write && (s_axil_awaddr == 7'h20) && s_axil_wdata[0];
      start_q       <= write && (s_axil_awaddr == 7'h20) && s_axil_wdata[1];
      prepare_q     <= write && (s_axil_awaddr == 7'h20) && s_axil_wdata[2];
      ray_clear_q   <= write && (s_axil_awaddr == 7'h20) && s_axil_wdata[3];
      ray_start_q   <= write && (s_axil_awaddr == 7'h20) && s_axil_wdata[4];
      if (write) begin
        case (s_axil_awaddr)
          7'h40:   light_q.xs <= s_axil_wdata[rc2_pkg::CoordW-1:0];
          7'h44:   light_q.ys <= s_axil_wdata[rc2_pkg::CoordW-1:0];
          7'h48:   light_q.zs <= s_axil_wdata[rc2_pkg::CoordW-1:0];
          7'h4C:   light_q.distance <= s_axil_wdata[rc2_pkg::DistanceW-1:0];
          7'h50:   light_q.fa <= s_axil_wdata[rc2_pkg::QueueW-1:0];
          7'h54:   targets_q <= s_axil_wdata[HomeW-1:0];
          7'h58:   light_q.inverse <= s_axil_wdata[rc2_pkg::SlopeW-1:0];
          7'h74:   accurate_q <= s_axil_wdata[0];
          7'h6C:
          if (rc2_pkg::RAYS) begin
            limits_q.depth  <= s_axil_wdata[rc2_pkg::DepthW-1:0];
            limits_q.places <= s_axil_wdata[8+:rc2_pkg::RayCountW];
            limits_q.least  <= s_axil_wdata[16+:rc2_pkg::WeightW];
          end
          default: ;
        endcase
      end
    end
  end

  // ---- What happened ---------------------------------------------------------------------------
  logic [31:0] busy_cycles_q, since_q, home_cycle_q;
  logic [HomeW-1:0] home_q, skipped_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      busy_cycles_q <= '0;
      since_q       <= '0;
      home_cycle_q  <= '0;
      home_q        <= '0;
      skipped_q     <= '0;
    end else begin
      since_q <= start_q ? 32'd1 : since_q + 1'b1;
      if (clear_q || prepare_q || start_q || ray_clear_q || ray_start_q) busy_cycles_q <= '0;
      else if (array_busy) busy_cycles_q <= busy_cycles_q + 1'b1;
      if (start_q) begin
        home_q       <= '0;
        home_cycle_q <= '0;
        skipped_q    <= '0;
      end else if (home != 0) begin
        home_q       <= home_q + home;
        skipped_q    <= skipped_q + skipped;
        home_cycle_q <= since_q + 1'b1;
      end
    end
  end

  // ---- Registers: read -------------------------------------------------------------------------
  logic read;
  assign read = s_axil_arvalid && !s_axil_rvalid;
  assign s_axil_arready = read;
  assign s_axil_rresp = 2'b00;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) s_axil_rvalid <= 1'b0;
    else s_axil_rvalid <= read || (s_axil_rvalid && !s_axil_rready);
    if (read) begin
      case (s_axil_araddr)
        7'h00:   s_axil_rdata <= Id;
        7'h04:   s_axil_rdata <= rc2_pkg::N;
        7'h08:   s_axil_rdata <= rc2_pkg::F;
        7'h0C:   s_axil_rdata <= rc2_pkg::LMAX;
        7'h10:   s_axil_rdata <= rc2_pkg::FAMAX;
        7'h14:   s_axil_rdata <= rc2_pkg::HostWordW;
        7'h18:   s_axil_rdata <= rc2_pkg::DataW;
        7'h1C:   s_axil_rdata <= rc2_pkg::FacetW;
        7'h34:   s_axil_rdata <= {8'(rc2_pkg::GapFractionW), 8'(rc2_pkg::GapW),
                                  8'(rc2_pkg::NormalFractionW), 8'(rc2_pkg::NormalW)};
        7'h38:   s_axil_rdata <= rc2_pkg::FEEDERS;
        7'h3C:   s_axil_rdata <= 32'(rc2_pkg::LAYERS);
        7'h24:   s_axil_rdata <= {30'd0, (home_q == targets_q), busy};
        7'h28:   s_axil_rdata <= busy_cycles_q;
        7'h2C:   s_axil_rdata <= home_cycle_q;
        7'h30:   s_axil_rdata <= 32'(home_q);
        7'h64:   s_axil_rdata <= 32'(skipped_q);
        7'h40:   s_axil_rdata <= 32'(light_q.xs);
        7'h44:   s_axil_rdata <= 32'(light_q.ys);
        7'h48:   s_axil_rdata <= 32'(light_q.zs);
        7'h4C:   s_axil_rdata <= 32'(light_q.distance);
        7'h50:   s_axil_rdata <= 32'(light_q.fa);
        7'h54:   s_axil_rdata <= 32'(targets_q);
        7'h58:   s_axil_rdata <= 32'(light_q.inverse);
        7'h5C:   s_axil_rdata <= {29'd0, rc2_pkg::SKIPS, rc2_pkg::COUNTS, rc2_pkg::THESIS};
        7'h60:   s_axil_rdata <= rc2_pkg::SlopeW;
        7'h68:   s_axil_rdata <= rc2_pkg::RAYS ? (rc2_pkg::RAYQ << 8) | rc2_pkg::RAYDEPTH : 0;
        7'h6C:
        s_axil_rdata <= {3'd0, limits_q.least, 8'(limits_q.places), 8'(limits_q.depth)};
        7'h74:   s_axil_rdata <= 32'(accurate_q);
        default: s_axil_rdata <= '0;
      endcase
    end
  end

  // Contract: no command while the array works; no target comes home twice; a beat stays.
  logic waiting_q;
  logic [ReadW-1:0] beat_q;
  always_ff @(posedge clk_i) begin
    waiting_q <= rst_ni && m_axis_tvalid && !m_axis_tready;
    beat_q    <= m_axis_tdata;
    if (rst_ni) begin
      assert (!((clear_q || prepare_q || start_q || ray_clear_q || ray_start_q) && busy));
      assert (!waiting_q || (m_axis_tvalid && m_axis_tdata == beat_q));
      assert (home == 0 || home_q + home <= targets_q);
    end
  end
endmodule
