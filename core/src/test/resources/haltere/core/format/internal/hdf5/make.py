"""Makes the files beside it, which Hdf5FormatTest reads: python make.py FOLDER ECF.so (h5py 3.16, hdf5plugin 7.1).

ECF.so has size_t encode(EventCD *events, size_t count, uint8_t *to), which calls the encoder of prophesee-ai/hdf5_ecf.
"""
import ctypes,h5py,numpy as np,hdf5plugin,gzip,os,sys
d=sys.argv[1]; n=300
i=np.arange(n)
t=(1000000+i*7+i//150*1000000).astype(np.int64); x=(i*31%346).astype(np.uint16); y=(i*17%260).astype(np.uint16); p=(i//3%2).astype(np.uint8)
def f(name,**kw): return h5py.File(os.path.join(d,name+'.h5'),'w',**kw)
def cols(h,chunks=None,maxshape=None,tt=t,pp=p,**kw):
    g=h.create_group('events')
    for k,v in dict(t=tt,x=x,y=y,p=pp).items(): g.create_dataset(k,data=v,chunks=chunks,maxshape=maxshape,**kw)
    h.attrs['width']=346; h.attrs['height']=260
with f('old-deflate-shuffle-fletcher32') as h: cols(h,(50,),compression='gzip',shuffle=True,fletcher32=True)
with f('new-growing',libver='latest') as h: cols(h,(3,),(None,))
with f('new-array-lzf',libver='latest') as h: cols(h,(30,),compression='lzf')
with f('new-single-deflate',libver='latest') as h: cols(h,(n,),compression='gzip')
with f('new-run',libver='latest') as h: cols(h)
with f('blosc-zstd') as h: cols(h,(200,),**hdf5plugin.Blosc(cname='zstd',clevel=5,shuffle=1))
with f('blosc-blosclz-bits') as h: cols(h,(200,),**hdf5plugin.Blosc(cname='blosclz',clevel=5,shuffle=2))
with f('blosc-lz4') as h: cols(h,(200,),**hdf5plugin.Blosc(cname='lz4',clevel=5,shuffle=1))
with f('zstd') as h: cols(h,(200,),**hdf5plugin.Zstd())
with f('lz4') as h: cols(h,(200,),**hdf5plugin.LZ4())
with f('dsec') as h:
    cols(h,(200,),tt=(t-t[0]).astype(np.uint32),compression='gzip'); h['t_offset']=t[0]
    h['ms_to_idx']=np.searchsorted(t-t[0],np.arange(0,10)*1000).astype(np.uint64)
a=np.zeros(n,dtype=[('x','<u2'),('y','<u2'),('p','<i2'),('t','<i8')]); a['x']=x;a['y']=y;a['p']=p;a['t']=t
def prophesee(h,**kw):
    h.create_dataset('CD/events',data=a,chunks=(100,),**kw); h.create_dataset('CD/indexes',data=np.zeros(5,dtype=[('id','u8'),('ts','i8')]))
    h.create_dataset('EXT_TRIGGER/events',data=np.zeros(3,dtype=[('p','<i2'),('t','<i8'),('id','<i2')]))
    h.attrs['geometry']='346x260'; h.attrs['format']='HDF5'
with f('prophesee') as h: prophesee(h,compression='gzip')
with f('prophesee-triggers') as h:
    h['CD/events']=a; e=np.zeros(5,dtype=[('p','<i2'),('t','<i8'),('id','<i2')])
    e['t']=[999000,1000014,1000700,2001050,2500000]; e['p']=[1,0,1,0,1]; e['id']=[0,0,6,6,0]
    h.create_dataset('EXT_TRIGGER/events',data=e,chunks=(100,),maxshape=(None,)); h.attrs['geometry']='346x260'
def ecf(name,events,chunk):
    # as Metavision writes it: the last chunk has fewer events
    encode=ctypes.CDLL(sys.argv[2]).encode; encode.restype=ctypes.c_size_t
    kind=np.dtype(dict(names=['x','y','p','t'],formats=['<u2','<u2','<i2','<i8'],offsets=[0,2,4,8],itemsize=16))
    with f(name) as h:
        c=h5py.h5p.create(h5py.h5p.DATASET_CREATE); c.set_chunk((chunk,)); c.set_filter(36559,h5py.h5z.FLAG_OPTIONAL,())
        size=h5py.h5s.create_simple((len(events),),(h5py.h5s.UNLIMITED,))
        d=h5py.h5d.create(h.create_group('CD').id,b'events',h5py.h5t.py_create(kind),size,c)
        for i in range(0,len(events),chunk):
            part=np.zeros(len(events[i:i+chunk]),dtype=kind); to=ctypes.create_string_buffer(100+12*len(part))
            for k in 'xypt': part[k]=events[k][i:i+chunk]
            length=encode(part.ctypes.data_as(ctypes.c_void_p),ctypes.c_size_t(len(part)),to); d.write_direct_chunk((i,),to.raw[:length],0)
        h.attrs['geometry']='346x260'
ecf('prophesee-ecf',a,128)
j=np.arange(10000); b=np.zeros(10000,dtype=a.dtype)
b['t']=1000+j//50*3+j//200*20+j//5000*12345678; b['p']=j//150%2
b['y']=np.where(j<4000,j//40,np.where(j<8000,j//20%200,j*17%240)); b['x']=np.where(j<4000,5+j%20,j*37%320)
ecf('prophesee-ecf-rows',b,4000)
with f('fields-nanoseconds') as h:
    b=np.zeros(n,dtype=[('t_ns','<i8'),('x','<u2'),('y','<u2'),('p','i1')]); b['x']=x;b['y']=y;b['p']=p;b['t_ns']=t*1000
    h['events']=b; h.attrs['geometry']='346x260'
with f('table-one-row-seconds') as h: h['events']=np.array([[639,93,0.04667,1]])
with f('rows-without-numbers') as h:
    for k,v in dict(t=[5,np.nan,7,np.inf,1e300,9],x=np.arange(6),y=[1,1,1,1,1,np.nan],p=np.ones(6,np.uint8)).items(): h['events/'+k]=v
with f('table-txyp') as h: h.create_dataset('events',data=np.stack([t,x,y,p],axis=1).astype(np.uint32),chunks=(100,4),maxshape=(None,4),compression='gzip')
with f('table-xytp-seconds') as h: h.create_dataset('davis/left/events',data=np.stack([x,y,t/1e6,p*2.0-1],axis=1),chunks=(100,4),compression='gzip')
with f('table-by-columns') as h: h.create_dataset('events',data=np.stack([t,x,y,p],axis=1).astype(np.uint32),chunks=(100,1),compression='gzip')
with f('table-pairs-of-columns') as h: h.create_dataset('events',data=np.stack([x,y,p,t],axis=1).astype(np.uint32),chunks=(40,2),maxshape=(None,4),compression='gzip')
with f('new-table-three-columns',libver='latest') as h: h.create_dataset('events',data=np.stack([t,x,y,p],axis=1).astype(np.uint32),chunks=(70,3),compression='lzf')
with f('new-growing-table-by-columns',libver='latest') as h: h.create_dataset('events',data=np.stack([t,x,y,p],axis=1).astype(np.uint32),chunks=(9,1),maxshape=(None,4))
with f('two-cameras') as h:
    for side,k in (('right',7),('left',0)):
        g=h.create_group('cameras/'+side); g['t']=t[k:]; g['x']=x[k:]; g['y']=y[k:]; g['p']=p[k:]
    h['imu/events']=np.zeros((5,4))+.5
with f('seconds-big-endian-truth') as h:
    h['events/xs']=x.astype('i2'); h['events/ys']=y.astype('>i2'); h['events/ts']=t/1e6; h['events/ps']=p.astype(bool)
    h['images/image000']=np.zeros((3,3))
with f('nanoseconds-user-block',userblock_size=512) as h:
    g=h.create_group('events'); g['t_ns']=t*1000; g['x']=x; g['y']=y; g['p']=p
def other(name,number):
    with f(name) as h:
        for k,v in dict(t=t,x=x,y=y,p=p).items():
            c=h5py.h5p.create(h5py.h5p.DATASET_CREATE); c.set_chunk((100,)); c.set_filter(number,h5py.h5z.FLAG_OPTIONAL,())
            h5py.h5d.create(h.id,k.encode(),h5py.h5t.py_create(v.dtype),h5py.h5s.create_simple((n,)),c).write(h5py.h5s.ALL,h5py.h5s.ALL,v)
other('filter-ecf',36559); other('filter-unknown',54321)
with f('large-chunks') as h: 
    g=h.create_group('events')
    for k,v in dict(t=t,x=x,y=y,p=p).items(): g.create_dataset(k,shape=(0,),maxshape=(None,),dtype=v.dtype,chunks=(4000000,),compression='gzip')
def lists(h,path='events/',**changed):
    for k,v in {**dict(t=t,x=x,y=y,p=p),**changed}.items(): h[path+k]=v
    h.attrs['width']=346; h.attrs['height']=260
def matlab(h,shape,chunks):
    for k,v in dict(ts=t,x=x,y=y,p=p).items(): h.create_dataset('TD/'+k,data=v.astype(float).reshape(shape),chunks=chunks,compression='gzip',compression_opts=3).attrs['MATLAB_class']=np.bytes_('double')
    h.attrs['width']=346; h.attrs['height']=260
with f('matlab-column',userblock_size=512) as h: matlab(h,(1,n),(1,70))
with f('matlab-row',userblock_size=512) as h: matlab(h,(n,1),(70,1))
with f('new-lists-of-one-row',libver='latest') as h:
    for k,v in dict(t=t,x=x,y=y,p=p).items(): h.create_dataset('events/'+k,data=v[None],chunks=(1,33),compression='gzip')
    h.attrs['width']=346; h.attrs['height']=260
with f('microseconds-in-greek') as h:
    lists(h); h.move('events/t','events/t [\u00b5s]')
with f('nanoseconds-by-attribute') as h:
    lists(h,t=t*1000); h['events/t'].attrs['units']='ns'
with f('polarities-of-255') as h: lists(h,p=p*255)
with f('polarities-of-text') as h: lists(h,p=np.where(p,'ON','OFF').astype('S3'))
with f('polarities-one-and-two') as h: lists(h,p=p+1)
with f('frames-first') as h:
    for k in range(520): h.create_dataset('camera/%04d'%k,shape=(),dtype='u1')
    lists(h)
with open(os.path.join(d,'frames-first.h5'),'rb') as plain, gzip.open(os.path.join(d,'frames-first.h5.gz'),'wb') as packed: packed.write(plain.read())
os.remove(os.path.join(d,'frames-first.h5'))
with f('no-events') as h: h['weights']=np.zeros((2,2))
